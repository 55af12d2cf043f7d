// SPDX-License-Identifier: BSD-3-Clause
#include "Model/MomentLimits.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>

namespace nexrad
{

namespace
{

// Radars state the Nyquist velocity more coarsely than they fold velocities.
constexpr float nyquistTolerance = 1.0F; // m/s

struct Limits
{
  float least;
  float most;
};

// Gates whose word is a value outside the limits. Nearly always there is none, which a loop without
// branches finds out soonest.
std::vector<std::size_t> GatesOutside(const MomentRow& row, const Limits& limits)
{
  const auto isOutside = [&](std::size_t gate)
  {
    const float value = row.Value(gate);
    return row.Raw(gate) >= row.firstValue && (value < limits.least || value > limits.most);
  };
  bool any = false;
  for (std::size_t gate = 0; gate < row.gates; ++gate)
  {
    any |= isOutside(gate);
  }
  std::vector<std::size_t> outside;
  for (std::size_t gate = 0; any && gate < row.gates; ++gate)
  {
    if (isOutside(gate))
    {
      outside.push_back(gate);
    }
  }
  return outside;
}

std::vector<std::size_t> NegativeWidths(const Ray& ray)
{
  return GatesOutside(ray.Row(MomentName::SW), {0.0F, std::numeric_limits<float>::infinity()});
}

bool HaveTheSameGates(const MomentRow& a, const MomentRow& b)
{
  return a.gates == b.gates && a.firstGate == b.firstGate && a.gateSpacing == b.gateSpacing;
}

std::vector<std::size_t> ImpossibleVelocities(const Ray& ray)
{
  const MomentRow& row = ray.Row(MomentName::VEL);
  std::vector<std::size_t> folded;
  if (ray.nyquist > 0.0F)
  {
    const float most = ray.nyquist + nyquistTolerance;
    folded = GatesOutside(row, {-most, most});
  }
  if (!HaveTheSameGates(row, ray.Row(MomentName::SW)))
  {
    return folded;
  }
  std::vector<std::size_t> beside = NegativeWidths(ray);
  beside.erase(std::remove_if(beside.begin(), beside.end(),
                 [&row](std::size_t gate) { return row.State(gate) != GateState::Valid; }),
    beside.end());
  std::vector<std::size_t> both;
  std::set_union(
    folded.begin(), folded.end(), beside.begin(), beside.end(), std::back_inserter(both));
  return both;
}

std::size_t CountGates(const std::vector<Sweep>& sweeps, MomentName moment)
{
  std::size_t count = 0;
  for (const Sweep& sweep : sweeps)
  {
    for (const Ray& ray : sweep.rays)
    {
      count += ImpossibleGates(ray, moment).size();
    }
  }
  return count;
}

} // namespace

std::vector<std::size_t> ImpossibleGates(const Ray& ray, MomentName moment)
{
  switch (moment)
  {
  case MomentName::VEL:
    return ImpossibleVelocities(ray);
  case MomentName::SW:
    return NegativeWidths(ray);
  default:
    return {};
  }
}

std::string DescribeImpossibleGates(const std::vector<Sweep>& sweeps)
{
  const std::size_t widths = CountGates(sweeps, MomentName::SW);
  const std::size_t velocities = CountGates(sweeps, MomentName::VEL);
  if (widths + velocities == 0)
  {
    return "";
  }
  return std::to_string(widths) + " gates have a spectrum width below 0 m/s, " +
         std::to_string(velocities) +
         " a velocity beside such a width or beyond the Nyquist velocity: no measurement gives "
         "these, and merging leaves them out";
}

} // namespace nexrad

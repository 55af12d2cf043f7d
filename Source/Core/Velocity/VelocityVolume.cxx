// SPDX-License-Identifier: BSD-3-Clause
#include "nexrad/Velocity/VelocityVolume.h"

#include "nexrad/Geometry/Angles.h"
#include "nexrad/System/Error.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <utility>

namespace nexrad
{

namespace
{

VelocitySweep MakeSweep(const PolarSweep& polar)
{
  VelocitySweep sweep;
  sweep.elevationNumber = polar.elevationNumber;
  sweep.elevation = MedianElevation(polar);
  sweep.firstGate = polar.firstGate;
  sweep.gateSpacing = polar.gateSpacing;
  sweep.gates = polar.gates;
  sweep.values.reserve(polar.rays.size() * polar.gates);
  sweep.states.reserve(polar.rays.size() * polar.gates);
  std::vector<std::uint16_t> codes(polar.gates);
  for (std::size_t ray = 0; ray < polar.rays.size(); ++ray)
  {
    const PolarRay& own = polar.rays[ray];
    sweep.rays.push_back({own.azimuth, own.elevation, own.nyquist, own.time});
    polar.Read(ray, codes.data());
    for (const std::uint16_t code : codes)
    {
      const auto state = static_cast<VelocityState>(StateOf(code));
      sweep.states.push_back(state);
      sweep.values.push_back(state == VelocityState::Valid
                               ? polar.scale.ValueOf(code)
                               : std::numeric_limits<float>::quiet_NaN());
    }
  }
  return sweep;
}

} // namespace

VelocityVolume MakeVelocityVolume(const RadarVolume& volume)
{
  return MakeVelocityVolume(MakePolarVolume(volume, MomentName::VEL));
}

VelocityVolume MakeVelocityVolume(const PolarVolume& volume)
{
  VelocityVolume velocities;
  velocities.site = volume.site;
  velocities.start = volume.start;
  velocities.end = volume.end;
  velocities.synthetic = volume.synthetic;
  for (const PolarSweep& sweep : volume.sweeps)
  {
    velocities.sweeps.push_back(MakeSweep(sweep));
  }
  return velocities;
}

namespace
{

constexpr double widestStep = 1.6; // degrees between two rays that are neighbours
constexpr double binWidth = 0.5;   // degrees
constexpr std::size_t bins = 720;

std::vector<std::pair<float, std::size_t>> OrderRays(const VelocitySweep& sweep)
{
  std::vector<std::pair<float, std::size_t>> order;
  for (std::size_t ray = 0; ray < sweep.rays.size(); ++ray)
  {
    const float turned = std::fmod(sweep.rays[ray].azimuth, 360.0F);
    order.emplace_back(turned < 0.0F ? turned + 360.0F : turned, ray);
  }
  std::sort(order.begin(), order.end());
  return order;
}

} // namespace

SweepRing MakeSweepRing(const VelocitySweep& sweep)
{
  SweepRing ring;
  ring.rows = sweep.rays.size();
  ring.gates = sweep.gates;
  ring.elevation = sweep.elevation;
  ring.firstGate = sweep.firstGate;
  ring.gateSpacing = sweep.gateSpacing;
  ring.velocity.reserve(ring.rows * ring.gates);
  for (const auto& [azimuth, ray] : OrderRays(sweep))
  {
    ring.ray.push_back(ray);
    ring.azimuth.push_back(azimuth);
    ring.nyquist.push_back(sweep.rays[ray].nyquist);
    const auto first = sweep.values.begin() + static_cast<std::ptrdiff_t>(sweep.Index(ray, 0));
    ring.velocity.insert(
      ring.velocity.end(), first, first + static_cast<std::ptrdiff_t>(sweep.gates));
    if (!(ring.nyquist.back() > 0.0F))
    {
      std::fill(ring.velocity.end() - static_cast<std::ptrdiff_t>(sweep.gates), ring.velocity.end(),
        std::numeric_limits<float>::quiet_NaN());
    }
  }
  for (std::size_t row = 0; row < ring.rows; ++row)
  {
    const double step = AngleDifference(
      static_cast<double>(ring.azimuth[row]), static_cast<double>(ring.azimuth[ring.NextRow(row)]));
    ring.beside.push_back(ring.rows > 2 && std::abs(step) <= widestStep ? 1 : 0);
  }
  return ring;
}

RowFinder::RowFinder(const SweepRing& ring)
  : rowOfBin(bins, None)
{
  std::vector<double> apart(bins, widestStep);
  for (std::size_t row = 0; row < ring.rows; ++row)
  {
    const auto centre =
      static_cast<std::ptrdiff_t>(static_cast<double>(ring.azimuth[row]) / binWidth);
    for (std::ptrdiff_t step = -3; step <= 3; ++step)
    {
      const auto bin = static_cast<std::size_t>((centre + step + std::ptrdiff_t(bins))) % bins;
      const double distance = std::abs(AngleDifference(
        (static_cast<double>(bin) + 0.5) * binWidth, static_cast<double>(ring.azimuth[row])));
      if (distance < apart[bin])
      {
        apart[bin] = distance;
        rowOfBin[bin] = row;
      }
    }
  }
}

std::size_t RowFinder::RowAt(float azimuth) const
{
  return rowOfBin[static_cast<std::size_t>(static_cast<double>(azimuth) / binWidth) % bins];
}

} // namespace nexrad

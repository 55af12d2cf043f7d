// SPDX-License-Identifier: BSD-3-Clause
#include "nexrad/Quality/SplitCuts.h"

#include "nexrad/Geometry/Angles.h"
#include "nexrad/Model/Elevation.h"
#include "nexrad/Polar/PolarVolume.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace nexrad
{

namespace
{

constexpr double sameDirection = 0.75; // degrees

// The rays of a sweep that have a moment, by azimuth.
class RaysWith
{
public:
  RaysWith(const Sweep& sweep, MomentName moment)
  {
    for (const Ray& ray : sweep.rays)
    {
      if (ray.Row(moment).gates > 0)
      {
        rays.emplace_back(static_cast<double>(ray.azimuth), &ray);
      }
    }
    std::sort(rays.begin(), rays.end());
  }

  // nullptr where none is near enough.
  const Ray* Nearest(double azimuth) const
  {
    if (rays.empty())
    {
      return nullptr;
    }
    const auto next = std::lower_bound(rays.begin(), rays.end(), azimuth,
      [](const auto& ray, double wanted) { return ray.first < wanted; });
    const auto& after = next == rays.end() ? rays.front() : *next;
    const auto& before = next == rays.begin() ? rays.back() : *(next - 1);
    const double toAfter = std::abs(AngleDifference(after.first, azimuth));
    const double toBefore = std::abs(AngleDifference(before.first, azimuth));
    const bool isAfter = toAfter < toBefore;
    return std::min(toAfter, toBefore) > sameDirection ? nullptr
                                                       : (isAfter ? after : before).second;
  }

private:
  std::vector<std::pair<double, const Ray*>> rays;
};

// The sweep itself where it has a moment, else its neighbour at the same tilt that does; nullptr
// where neither does.
const Sweep* FindCutWith(const RadarVolume& volume, const std::vector<double>& elevations,
  std::size_t own, MomentName moment)
{
  if (volume.sweeps[own].Has(moment))
  {
    return &volume.sweeps[own];
  }
  const auto serves = [&](std::size_t other)
  {
    return other < volume.sweeps.size() &&
           std::abs(elevations[other] - elevations[own]) <= SameTilt &&
           volume.sweeps[other].Has(moment);
  };
  // Velocity comes after reflectivity in a split cut, and polarimetry before it.
  const std::size_t after = own + 1;
  const std::size_t before = own - 1; // beyond the end for the first
  const bool later = moment == MomentName::VEL ? serves(after) || !serves(before) : !serves(before);
  const std::size_t other = later ? after : before;
  return serves(other) ? &volume.sweeps[other] : nullptr;
}

void FindRays(const Sweep* sweep, MomentName moment, const std::vector<const Ray*>& own,
  std::vector<const Ray*>& found)
{
  found.assign(own.size(), nullptr);
  if (sweep == nullptr)
  {
    return;
  }
  const RaysWith rays(*sweep, moment);
  for (std::size_t i = 0; i < own.size(); ++i)
  {
    const bool itself = own[i]->Row(moment).gates > 0;
    found[i] = itself ? own[i] : rays.Nearest(static_cast<double>(own[i]->azimuth));
  }
}

} // namespace

std::vector<SweepSources> FindSources(const RadarVolume& volume)
{
  std::vector<double> elevations;
  for (const Sweep& sweep : volume.sweeps)
  {
    elevations.push_back(sweep.MedianElevation());
  }
  std::vector<SweepSources> all;
  for (std::size_t i = 0; i < volume.sweeps.size(); ++i)
  {
    for (std::vector<const Ray*>& rays : RaysByGeometry(volume.sweeps[i], MomentName::REF))
    {
      SweepSources sources;
      sources.sweep = i;
      sources.own = std::move(rays);
      FindRays(FindCutWith(volume, elevations, i, MomentName::VEL), MomentName::VEL, sources.own,
        sources.velocity);
      FindRays(FindCutWith(volume, elevations, i, MomentName::RHO), MomentName::RHO, sources.own,
        sources.twoWaves);
      all.push_back(std::move(sources));
    }
  }
  return all;
}

} // namespace nexrad

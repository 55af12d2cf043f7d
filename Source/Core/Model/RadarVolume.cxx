// SPDX-License-Identifier: BSD-3-Clause
#include "Model/RadarVolume.h"

#include "Model/Elevation.h"

#include <algorithm>

namespace nexrad
{

double Sweep::MeanElevation() const
{
  double sum = 0.0;
  for (const Ray& ray : rays)
  {
    sum += ray.elevation;
  }
  return rays.empty() ? 0.0 : sum / static_cast<double>(rays.size());
}

double Sweep::MedianElevation() const
{
  std::vector<double> elevations;
  for (const Ray& ray : rays)
  {
    elevations.push_back(ray.elevation);
  }
  return MedianOf(std::move(elevations));
}

bool Sweep::Has(MomentName name) const
{
  return std::any_of(
    rays.begin(), rays.end(), [name](const Ray& ray) { return ray.Row(name).gates > 0; });
}

std::size_t RadarVolume::RayCount() const
{
  std::size_t count = 0;
  for (const Sweep& sweep : sweeps)
  {
    count += sweep.rays.size();
  }
  return count;
}

std::optional<Time> RadarVolume::Start() const
{
  return sweeps.empty() ? std::nullopt : std::optional<Time>(sweeps.front().rays.front().time);
}

std::optional<Time> RadarVolume::End() const
{
  return sweeps.empty() ? std::nullopt : std::optional<Time>(sweeps.back().rays.back().time);
}

std::vector<RadarVolume> SplitCycles(const RadarVolume& volume)
{
  constexpr std::uint8_t startOfVolume = 3;
  RadarVolume common = volume;
  common.sweeps.clear();
  std::vector<RadarVolume> cycles;
  for (const Sweep& sweep : volume.sweeps)
  {
    if (cycles.empty() || sweep.rays.front().radialStatus == startOfVolume ||
        sweep.elevationNumber < cycles.back().sweeps.back().elevationNumber)
    {
      cycles.push_back(common);
    }
    cycles.back().sweeps.push_back(sweep);
  }
  if (cycles.empty())
  {
    cycles.push_back(common);
  }
  return cycles;
}

} // namespace nexrad

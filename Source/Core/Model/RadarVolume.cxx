// SPDX-License-Identifier: BSD-3-Clause
#include "nexrad/Model/RadarVolume.h"

#include "nexrad/Model/Elevation.h"

#include <algorithm>
#include <functional>
#include <utility>

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

std::vector<const Ray*> Sweep::StrayRays(double beamWidth) const
{
  const double elevation = this->MedianElevation();
  std::vector<const Ray*> strays;
  for (const Ray& ray : rays)
  {
    if (IsStray(static_cast<double>(ray.elevation), elevation, beamWidth))
    {
      strays.push_back(&ray);
    }
  }
  return strays;
}

bool Sweep::Has(MomentName name) const
{
  return std::any_of(rays.begin(), rays.end(),
    [measured = MeasuredFor(name)](const Ray& ray) { return ray.Row(measured).gates > 0; });
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

namespace
{

using Buffer = std::shared_ptr<const std::vector<std::uint8_t>>;

// Those buffers, sorted by their places in memory, that the rays of some sweeps point into.
std::vector<Buffer> BuffersOf(const std::vector<Sweep>& sweeps, const std::vector<Buffer>& sorted)
{
  std::vector<bool> used(sorted.size(), false);
  const auto mark = [&](const MomentRow& row)
  {
    const auto next = std::upper_bound(sorted.begin(), sorted.end(), row.words,
      [](const std::uint8_t* words, const Buffer& buffer)
      { return std::less<>()(words, buffer->data()); });
    if (row.gates > 0 && next != sorted.begin())
    {
      used[static_cast<std::size_t>(next - sorted.begin()) - 1] = true;
    }
  };
  for (const Sweep& sweep : sweeps)
  {
    for (const Ray& ray : sweep.rays)
    {
      std::for_each(ray.moments.begin(), ray.moments.end(), mark);
    }
  }
  std::vector<Buffer> buffers;
  for (std::size_t index = 0; index < sorted.size(); ++index)
  {
    if (used[index])
    {
      buffers.push_back(sorted[index]);
    }
  }
  return buffers;
}

} // namespace

std::vector<RadarVolume> SplitCycles(const RadarVolume& volume)
{
  constexpr std::uint8_t startOfVolume = 3;
  RadarVolume common = volume;
  common.sweeps.clear();
  common.damage.clear();
  common.notes.clear();
  std::vector<Buffer> sorted = std::move(common.buffers);
  common.buffers.clear();
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
  std::sort(sorted.begin(), sorted.end(),
    [](const Buffer& a, const Buffer& b) { return std::less<>()(a->data(), b->data()); });
  for (RadarVolume& cycle : cycles)
  {
    cycle.buffers = BuffersOf(cycle.sweeps, sorted);
  }
  cycles.front().damage = volume.damage;
  cycles.front().notes = volume.notes;
  return cycles;
}

} // namespace nexrad

// SPDX-License-Identifier: BSD-3-Clause
#include "nexrad/Model/RadarVolume.h"

#include "nexrad/Model/Elevation.h"

#include <algorithm>
#include <cmath>
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

const CoverageCut* FindCut(const CoveragePattern& pattern, const Sweep& sweep)
{
  constexpr double sameCut = 0.5; // degrees
  const auto number = static_cast<std::size_t>(sweep.elevationNumber);
  if (number < 1 || number > pattern.cuts.size())
  {
    return nullptr;
  }
  const CoverageCut& cut = pattern.cuts[number - 1];
  return std::abs(cut.elevation - sweep.MedianElevation()) < sameCut ? &cut : nullptr;
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
  std::optional<Time> start;
  for (const Sweep& sweep : sweeps)
  {
    const Time first = sweep.rays.front().time;
    start = std::min(start.value_or(first), first);
  }
  return start;
}

std::optional<Time> RadarVolume::End() const
{
  std::optional<Time> end;
  for (const Sweep& sweep : sweeps)
  {
    const Time last = std::max(sweep.rays.front().time, sweep.rays.back().time);
    end = std::max(end.value_or(last), last);
  }
  return end;
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

// What was found of the cuts of each cycle when the file was decoded.
void SetCuts(const std::vector<VolumeCuts>& cuts, std::vector<RadarVolume>& cycles)
{
  for (std::size_t i = 0; i < cycles.size() && cuts.size() == cycles.size(); ++i)
  {
    cycles[i].cuts = {cuts[i]};
    cycles[i].complete = cuts[i].IsComplete();
    if (i > 0)
    {
      cycles[i].coveragePatternNumber = cuts[i].patternNumber;
      cycles[i].coveragePattern = cuts[i].pattern;
    }
  }
}

} // namespace

bool BeginsCycle(const Sweep& before, const Sweep& sweep)
{
  return sweep.rays.front().radialStatus == RadialStatus::StartOfVolume ||
         before.rays.back().radialStatus == RadialStatus::EndOfVolume ||
         sweep.elevationNumber < before.elevationNumber;
}

std::vector<RadarVolume> SplitCycles(const RadarVolume& volume)
{
  RadarVolume common = volume;
  common.sweeps.clear();
  common.damage.clear();
  common.notes.clear();
  common.cuts.clear();
  std::vector<Buffer> sorted = std::move(common.buffers);
  common.buffers.clear();
  std::vector<RadarVolume> cycles;
  for (const Sweep& sweep : volume.sweeps)
  {
    if (cycles.empty() || BeginsCycle(cycles.back().sweeps.back(), sweep))
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
  SetCuts(volume.cuts, cycles);
  cycles.front().damage = volume.damage;
  cycles.front().notes = volume.notes;
  return cycles;
}

bool LacksEnd(const RadarVolume& volume)
{
  return !volume.cuts.empty() && volume.cuts.back().left > Duration();
}

void EndWithNext(RadarVolume& volume, const RadarVolume& next)
{
  const bool isSameRadar =
    KeyOf(volume.site) == KeyOf(next.site) && !StandApart(volume.site, next.site);
  if (!LacksEnd(volume) || next.cuts.empty() || !isSameRadar ||
      !IsBrokenOff(volume.cuts.back().left, *next.Start() - *volume.End(), next.cuts.front().begun))
  {
    return;
  }
  VolumeCuts& cuts = volume.cuts.back();
  const auto rest = std::upper_bound(
    cuts.missing.begin(), cuts.missing.end(), volume.sweeps.back().elevationNumber);
  cuts.notScanned.assign(rest, cuts.missing.end());
  cuts.missing.erase(rest, cuts.missing.end());
  cuts.end = VolumeEnd::NewVolume;
  cuts.left = Duration();
  const auto isEnd = [](const Damage& damage) { return damage.isMissingEnd; };
  volume.damage.erase(
    std::remove_if(volume.damage.begin(), volume.damage.end(), isEnd), volume.damage.end());
  volume.complete = std::all_of(volume.cuts.begin(), volume.cuts.end(),
    [](const VolumeCuts& each) { return each.missing.empty(); });
  volume.notes.push_back(DescribeCuts(cuts).back() + ", of " + next.file);
}

} // namespace nexrad

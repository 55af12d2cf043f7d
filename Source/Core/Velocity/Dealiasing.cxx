// SPDX-License-Identifier: BSD-3-Clause
#include "nexrad/Velocity/Dealiasing.h"

#include "nexrad/Velocity/FoldFilling.h"
#include "nexrad/Velocity/FoldPlacement.h"
#include "nexrad/Velocity/FoldSupport.h"
#include "nexrad/Velocity/FoldedWind.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

namespace nexrad
{

namespace
{

std::vector<SweepFolds> FindClusters(const VelocityVolume& volume, const RangeLoop& loop)
{
  std::vector<std::optional<SweepFolds>> found(volume.sweeps.size());
  ForEachSweep(
    loop, found.size(), [&](std::size_t index) { found[index].emplace(volume.sweeps[index]); });
  std::vector<SweepFolds> sweeps;
  for (std::optional<SweepFolds>& sweep : found)
  {
    sweeps.push_back(std::move(*sweep));
  }
  return sweeps;
}

// The profile, with levels of another one at heights where it has none.
WindProfile Complete(WindProfile profile, const WindProfile& other)
{
  const WindProfile own = profile;
  for (const ProfileLevel& level : other.levels)
  {
    if (!own.At(level.height))
    {
      profile.levels.push_back(level);
    }
  }
  std::sort(profile.levels.begin(), profile.levels.end(),
    [](const ProfileLevel& a, const ProfileLevel& b) { return a.height < b.height; });
  return profile;
}

WindProfile ProfileFor(const std::vector<SweepFolds>& sweeps, const DealiasOptions& options)
{
  if (!options.wind.levels.empty())
  {
    return options.wind;
  }
  std::vector<const SweepRing*> rings;
  for (const SweepFolds& sweep : sweeps)
  {
    rings.push_back(&sweep.ring);
  }
  return Complete(FindFoldedWind(rings, options.loop), options.before);
}

DealiasCounts SetVelocities(const SweepFolds& folds, VelocitySweep& sweep)
{
  DealiasCounts counts;
  // Before they change: also those of rays without a Nyquist velocity, which the ring leaves out.
  counts.measured = static_cast<std::size_t>(std::count_if(
    sweep.values.begin(), sweep.values.end(), [](float value) { return !std::isnan(value); }));
  for (std::size_t row = 0; row < folds.ring.rows; ++row)
  {
    const std::size_t first = sweep.Index(folds.ring.ray[row], 0);
    for (std::size_t gate = 0; gate < folds.ring.gates; ++gate)
    {
      const std::size_t index = row * folds.ring.gates + gate;
      if (!folds.ring.HasValue(index))
      {
        continue;
      }
      const bool known = folds.gateFold[index] != NoFold;
      counts.unknown += known ? 0 : 1;
      counts.unfolded += known && folds.gateFold[index] != 0 ? 1 : 0;
      sweep.values[first + gate] = folds.Unfolded(row, gate); // NaN when not known
      sweep.states[first + gate] = known ? VelocityState::Valid : VelocityState::Unknown;
    }
  }
  return counts;
}

void CountJump(float a, float b, float nyquist, JumpCounts& counts)
{
  const float difference = std::abs(a - b);
  if (nyquist > 0.0F && !std::isnan(difference))
  {
    ++counts.pairs;
    counts.jumps += difference > nyquist ? 1 : 0;
  }
}

} // namespace

DealiasCounts Dealias(VelocityVolume& volume, const DealiasOptions& options)
{
  std::vector<SweepFolds> sweeps = FindClusters(volume, options.loop);
  const WindProfile wind = ProfileFor(sweeps, options);
  PlaceClusters(sweeps, wind, options.loop);
  ForEachSweep(options.loop, sweeps.size(), [&](std::size_t index) { FillFolds(sweeps[index]); });
  std::vector<std::vector<Fold>> folds(sweeps.size()); // apart: sweeps are read by others
  ForEachSweep(options.loop, sweeps.size(),
    [&](std::size_t index)
    { folds[index] = PlaceLoneGates(sweeps[index], ExpectedVelocities(sweeps, index, wind)); });
  ForEachSweep(options.loop, sweeps.size(),
    [&](std::size_t index) { sweeps[index].gateFold = std::move(folds[index]); });
  RemoveUnsupportedFolds(sweeps, wind, options.loop);
  std::vector<DealiasCounts> counts(sweeps.size());
  ForEachSweep(options.loop, sweeps.size(),
    [&](std::size_t index) { counts[index] = SetVelocities(sweeps[index], volume.sweeps[index]); });
  DealiasCounts sum;
  for (const DealiasCounts& each : counts)
  {
    sum.measured += each.measured;
    sum.unfolded += each.unfolded;
    sum.unknown += each.unknown;
  }
  return sum;
}

JumpCounts CountJumps(const VelocityVolume& volume)
{
  JumpCounts counts;
  for (const VelocitySweep& sweep : volume.sweeps)
  {
    const SweepRing ring = MakeSweepRing(sweep);
    for (std::size_t row = 0; row < ring.rows; ++row)
    {
      const float* here = &ring.velocity[row * ring.gates];
      const float* next = &ring.velocity[ring.NextRow(row) * ring.gates];
      for (std::size_t gate = 0; gate < ring.gates; ++gate)
      {
        if (gate + 1 < ring.gates)
        {
          CountJump(here[gate], here[gate + 1], ring.nyquist[row], counts);
        }
        if (ring.beside[row] != 0)
        {
          CountJump(here[gate], next[gate], ring.nyquist[row], counts);
        }
      }
    }
  }
  return counts;
}

} // namespace nexrad

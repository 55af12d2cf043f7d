// SPDX-License-Identifier: BSD-3-Clause
#include "LeaveOneOut.h"

#include "VolumeInterpolation.h"
#include "VolumeMotion.h"
#include "nexrad/System/Error.h"

#include <algorithm>
#include <cmath>

namespace nexrad
{

namespace
{

bool TellsSomething(VoxelState state)
{
  return state == VoxelState::Echo || state == VoxelState::NoEcho;
}

// The depth of nothing does not count.
float ScoredValue(const GriddedVolume& volume, std::size_t voxel)
{
  return volume.states[voxel] == VoxelState::Echo ? std::max(volume.values[voxel], 0.0F) : 0.0F;
}

} // namespace

double RebuildScore::Rmse() const
{
  return compared == 0 ? 0.0 : std::sqrt(squares / static_cast<double>(compared));
}

double RebuildScore::SuccessIndex(std::size_t threshold) const
{
  const std::size_t all = hits[threshold] + misses[threshold] + falseAlarms[threshold];
  return all == 0 ? 1.0 : static_cast<double>(hits[threshold]) / static_cast<double>(all);
}

RebuildScore& RebuildScore::operator+=(const RebuildScore& other)
{
  voxels += other.voxels;
  compared += other.compared;
  squares += other.squares;
  for (std::size_t i = 0; i < Thresholds.size(); ++i)
  {
    hits[i] += other.hits[i];
    misses[i] += other.misses[i];
    falseAlarms[i] += other.falseAlarms[i];
  }
  return *this;
}

RebuildScore ScoreRebuilt(const GriddedVolume& rebuilt, const GriddedVolume& observed)
{
  const std::size_t size = observed.values.size();
  if (rebuilt.values.size() != size || rebuilt.states.size() != size ||
      observed.states.size() != size)
  {
    throw Error("the rebuilt and the observed volume must have the same number of voxels");
  }
  RebuildScore score;
  for (std::size_t i = 0; i < size; ++i)
  {
    if (!TellsSomething(rebuilt.states[i]) || !TellsSomething(observed.states[i]))
    {
      continue;
    }
    ++score.voxels;
    const float got = ScoredValue(rebuilt, i);
    const float wanted = ScoredValue(observed, i);
    const double difference = static_cast<double>(got) - static_cast<double>(wanted);
    score.compared += got > 0.0F || wanted > 0.0F ? 1 : 0;
    score.squares += difference * difference;
    for (std::size_t t = 0; t < RebuildScore::Thresholds.size(); ++t)
    {
      const bool found = got >= RebuildScore::Thresholds[t];
      const bool there = wanted >= RebuildScore::Thresholds[t];
      score.hits[t] += found && there ? 1 : 0;
      score.misses[t] += !found && there ? 1 : 0;
      score.falseAlarms[t] += found && !there ? 1 : 0;
    }
  }
  return score;
}

LeaveOneOutScore LeaveOneOut(const GriddedVolume& first, const GriddedVolume& middle,
  const GriddedVolume& last, const MotionOptions& options)
{
  const MotionField motion = EstimateMotion(first, last, options);
  LeaveOneOutScore score;
  score.linear = ScoreRebuilt(InterpolateLinear(first, last, middle.time), middle);
  score.alongMotion =
    ScoreRebuilt(InterpolateAlongMotion(first, last, middle.time, motion), middle);
  return score;
}

} // namespace nexrad

// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "nexrad/Beams/BeamVolume.h"
#include "nexrad/Grid/GriddedVolume.h"
#include "nexrad/Gridding/BeamSampling.h"

#include <algorithm>
#include <cstddef>

namespace nexrad
{

/// An entry of a sweep and how far a direction lies on the way to the next; entry −1: no ray there.
struct RayPlace
{
  int entry;
  float share;
};

inline RayPlace FindRays(const BeamSweep& sweep, float azimuth)
{
  int entry = sweep.firstEntries[static_cast<std::size_t>(azimuth * BeamSweep::BinsPerDegree)];
  while (sweep.azimuths[static_cast<std::size_t>(entry) + 1] <= azimuth)
  {
    ++entry;
  }
  const auto at = static_cast<std::size_t>(entry);
  const float from = azimuth - sweep.azimuths[at];
  if (sweep.inverseGaps[at] > 0.0F)
  {
    return {entry, from * sweep.inverseGaps[at]};
  }
  if (from <= sweep.halfWidth)
  {
    return {entry, 0.0F};
  }
  return sweep.azimuths[at + 1] - azimuth <= sweep.halfWidth ? RayPlace{entry, 1.0F}
                                                             : RayPlace{-1, 0.0F};
}

/// s from the time of the merge at which a sweep, begun at `begin`, passed there.
inline float TimeOf(const BeamSweep& sweep, float begin, const RayPlace& rays)
{
  const auto entry = static_cast<std::size_t>(rays.entry);
  return begin + sweep.times[entry] + rays.share * (sweep.times[entry + 1] - sweep.times[entry]);
}

/// Elevation of the nearer of two rays, degrees.
inline float ElevationOf(const BeamSweep& sweep, const RayPlace& rays)
{
  return sweep
    .elevations[static_cast<std::size_t>(rays.share < 0.5F ? rays.entry : rays.entry + 1)];
}

/// Where a sweep passes over a column: the slant range, from the triangle of the antenna, the point
/// and the centre of the earth (Formulas G7).
inline float RangeOver(const BeamSweep& sweep, const ColumnDirection& column, float radius)
{
  const float t = column.halfTangent;
  return radius * 2.0F * t / (sweep.cosine * (1.0F - t * t) - 2.0F * sweep.sine * t);
}

/// Beyond the last gate nothing was measured, but above the weather there is nothing either (G4).
inline VoxelState BeyondReach(
  const BeamSweep& sweep, const ColumnDirection& column, const SamplingContext& context)
{
  const float t = column.halfTangent;
  const float height = (sweep.sine / sweep.cosine + t) * 2.0F * t / (1.0F + t * t);
  return height > context.ceiling ? VoxelState::NoEcho : VoxelState::NotScanned;
}

/// 1 up to two thirds of the largest gap, then down to 0 at the gap (Formulas A6).
inline float FadeOf(float age, float gap)
{
  return std::clamp(3.0F * (1.0F - age / gap), 0.0F, 1.0F);
}

} // namespace nexrad

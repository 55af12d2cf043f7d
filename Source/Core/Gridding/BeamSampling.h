// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "nexrad/Grid/SiteGeometry.h"
#include "nexrad/Gridding/BeamTilts.h"
#include "nexrad/Polar/GateCode.h"

#include <algorithm>
#include <cstddef>
#include <vector>

namespace nexrad
{

/// How fast the echo over a column moves as the radar sees it, in terms of ColumnDirection.
struct ColumnMotion
{
  float away = 0.0F;      ///< of tan(γ/2), 1/s: away from the radar
  float clockwise = 0.0F; ///< the same at right angles to it, clockwise
};

/// Where the echo that is over a column at the time of the merge stood, or will stand, at a time
/// `seconds` from it. Off by less than 0.003° and 0.1 % of the way.
ColumnDirection DirectionAt(
  const ColumnDirection& column, const ColumnMotion& motion, float seconds);

/// What sampling needs to know beside the tilt.
struct SamplingContext
{
  ValueRule rule;
  float gap = 900.0F;              ///< s: rays farther from the time do not count
  float effectiveRadius = 8.49e6F; ///< m
  bool ages = true;                ///< TiltSample::age is wanted
  float ceiling = 0.002F; ///< h/(a_e + h) of the height above which nothing can be (Formulas G4)
};

/// An entry of a sweep and how far a direction lies on the way to the next; entry −1: no ray there.
struct RayPlace
{
  int entry;
  float share;
};

inline RayPlace FindRays(const BeamSweep& sweep, float azimuth)
{
  const std::size_t at = sweep.EntryBefore(azimuth);
  const auto entry = static_cast<int>(at);
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

/// Samples one of a radar's tilts over a column into `sample`, which must be as it is made:
/// bilinear in azimuth and range in the last observation at or before the time and in the first one
/// after it, then linear in time (Formulas G2, G6, A1).
///
/// With a motion, both observations are sampled where the column's echo was and will be, when both
/// have an echo or no echo there (A2a). They are sampled on the tilt, whose height differs there,
/// but to opposite sides. An observation without one on the other side of the time is sampled there
/// as well, at the height over the column, between the neighbouring tilts; where these have neither
/// echo nor no echo, it is sampled over the column. Which observations are used, and their age,
/// follows from the column itself.
///
/// `nothingAbout`: no observation of the tilt has anything but no echo within the distance that
/// echo may move, so that none needs to be shifted.
void SampleTilt(const std::vector<BeamTilt>& tilts, std::size_t number,
  const ColumnDirection& column, const SamplingContext& context, const ColumnMotion* motion,
  bool nothingAbout, TiltSample& sample);

} // namespace nexrad

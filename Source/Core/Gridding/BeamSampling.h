// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "nexrad/Grid/SiteGeometry.h"
#include "nexrad/Gridding/BeamTilts.h"
#include "nexrad/Gridding/TiltSample.h"
#include "nexrad/Polar/ValueRule.h"

#include <cstddef>
#include <optional>
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

/// What a tilt has where no gate about a column holds anything but no echo, as far as one look
/// before and one after the time say so in all directions, both young enough to count in full.
struct QuietTilt
{
  const BeamSweep* before = nullptr; ///< nullptr: unknown
  const BeamSweep* after = nullptr;
  float nearest = 0.0F;       ///< tan(γ/2) from which both have gates
  float farthest = 0.0F;      ///< and to which
  std::uint8_t elevation = 0; ///< ElevationCode of the lowest sweep of any look
};

/// Unknown too while TiltSample::age is wanted, which differs from ray to ray.
QuietTilt FindQuiet(const BeamTilt& tilt, const SamplingContext& context);

/// SampleTilt for a column about which no sweep as high as `quiet.elevation` holds anything but no
/// echo; empty where it must be asked.
std::optional<TiltSample> SampleQuiet(
  const QuietTilt& quiet, const ColumnDirection& column, const SamplingContext& context);

/// Samples one of a radar's tilts over a column: bilinear in azimuth and range on the last look at
/// or before the time and on the first one after it, then linear in time (Formulas G2, G6, A1).
///
/// With a motion, the two looks go to where the column's echo was and will be, when both see
/// something there (A2a): on the tilt, whose height there differs, but to opposite sides. A look
/// that has none on the other side of the time goes there as well, at the height over the column,
/// between the neighbouring tilts; where these see nothing there, it stays. Which looks they are,
/// their age, and whether there is anything to tell, is decided over the column.
///
/// `nothingAbout`: no look at the tilt finds anything but no echo as far from the column as echo
/// may move, so that two looks need not be moved.
TiltSample SampleTilt(const std::vector<BeamTilt>& tilts, std::size_t number,
  const ColumnDirection& column, const SamplingContext& context,
  const ColumnMotion* motion = nullptr, bool nothingAbout = false);

} // namespace nexrad

// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "nexrad/Grid/SiteGeometry.h"
#include "nexrad/Gridding/BeamTilts.h"
#include "nexrad/Polar/GateCode.h"

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

/// Samples one of a radar's tilts over a column: bilinear in azimuth and range in the last
/// observation at or before the time and in the first one after it, then linear in time (Formulas
/// G2, G6, A1).
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
TiltSample SampleTilt(const std::vector<BeamTilt>& tilts, std::size_t number,
  const ColumnDirection& column, const SamplingContext& context,
  const ColumnMotion* motion = nullptr, bool nothingAbout = false);

} // namespace nexrad

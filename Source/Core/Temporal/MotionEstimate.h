// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Gridding/GriddedVolume.h"
#include "Temporal/MotionField.h"

namespace nexrad
{

struct MotionOptions
{
  double spacing = 20'000.0;  ///< m between nodes of the motion field, at most; above 0
  double maximumSpeed = 50.0; ///< m/s, no motion is faster; above 0
  double smoothness = 0.2; ///< (dBZ/km)², how much a difference between neighbouring nodes costs
                           ///< beside the slopes of the echo; above 0
};

/// Finds how the echo moved between two volumes (Formulas A3), from their column maxima, coarse to
/// fine. First the one displacement that fits all; then, from pixels of about 8 km to pixels of
/// about 2 km, the displacement at each node that makes half of it forwards from the first and
/// half of it backwards from the second meet, least squares with little weight for echo that grew
/// or decayed, and as smooth as `smoothness` asks. Where there is no echo the field continues that
/// of the neighbours; without any echo nothing moves. Throws Error when the volumes cannot be
/// interpolated between (RequirePair) or an option is not above 0.
MotionField EstimateMotion(
  const GriddedVolume& before, const GriddedVolume& after, const MotionOptions& options = {});

} // namespace nexrad

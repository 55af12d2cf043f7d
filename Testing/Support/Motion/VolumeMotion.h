// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "nexrad/Grid/GriddedVolume.h"
#include "nexrad/Motion/MotionEstimate.h"

namespace nexrad
{

/// Column maximum of a volume, weak echo as 0 dBZ.
MotionImage ColumnMaximum(const GriddedVolume& volume);

/// The motion between two volumes on one grid (Formulas A3), from their column maxima. Throws Error
/// when the volumes cannot be interpolated between (RequirePair), and as EstimateMotion of images.
MotionField EstimateMotion(
  const GriddedVolume& before, const GriddedVolume& after, const MotionOptions& options = {});

} // namespace nexrad

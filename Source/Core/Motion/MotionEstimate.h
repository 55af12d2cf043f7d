// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "nexrad/Motion/MotionField.h"
#include "nexrad/Motion/MotionImage.h"

#include <vector>

namespace nexrad
{

struct MotionOptions
{
  double spacing = 20'000.0;    ///< m between nodes of the motion field, at most; above 0
  double finestPixel = 2'000.0; ///< m, no image is halved beyond; above 0
  double maximumSpeed = 50.0;   ///< m/s, no motion is faster; above 0
  double smoothness = 0.2; ///< (dBZ/km)², how much a difference between neighbouring nodes costs
                           ///< beside the slopes of the echo; above 0
};

/// Two images of one radar, or of one merge, at two times. Not owned.
struct MotionPair
{
  const MotionPyramid* before = nullptr;
  const MotionPyramid* after = nullptr; ///< of the same sizes
  double seconds = 0.0;                 ///< between them, above 0
};

/// Finds the one motion of the echo (Formulas A3) that fits pairs of images of column maxima over
/// one grid, which may be of several radars and of several times, coarse to fine. First the one
/// displacement that fits all; then, from pixels of about 8 km to pixels of about 2 km, the
/// displacement at each node that makes half of it forwards from the first image and half of it
/// backwards from the second meet, least squares with little weight for echo that grew or decayed,
/// and as smooth as `smoothness` asks. Where there is no echo the field continues that of the
/// neighbours; without any echo, and without pairs, nothing moves. Throws Error when an option is
/// not above 0.
MotionField EstimateMotion(const std::vector<MotionPair>& pairs, const GridSpecification& grid,
  const MotionOptions& options = {});

} // namespace nexrad

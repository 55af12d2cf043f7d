// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "nexrad/Motion/MotionField.h"
#include "nexrad/Motion/MotionImage.h"

#include <array>
#include <vector>

namespace nexrad
{

struct MotionOptions
{
  double spacing = 20'000.0;    ///< m between nodes of the motion field, at most; above 0
  double finestPixel = 2'000.0; ///< m, no image is halved beyond; above 0
  double maximumSpeed = 50.0;   ///< m/s, no motion is faster; above 0
};

/// Two images of one radar, or of one merge, at two times. Not owned.
struct MotionPair
{
  const MotionPyramid* before = nullptr;
  const MotionPyramid* after = nullptr; ///< of the same sizes
  double seconds = 0.0;                 ///< between them, above 0
  double start = 0.0;                   ///< s since 1970, of the first one
};

/// Finds the one motion of the echo (Formulas A3) that fits pairs of images of column maxima over
/// one grid, which may be of several radars and of several times, coarse to fine. First the one
/// displacement that fits all; then, from pixels of about 8 km to pixels of about 2 km, the
/// displacement at each node that makes half of it forwards from the first image and half of it
/// backwards from the second meet, least squares with little weight for echo that grew or decayed,
/// and smooth. Where there is no echo the field continues that of the neighbours; without any echo,
/// and without pairs, nothing moves. Throws Error as MakeMotionLattice does.
MotionField EstimateMotion(const std::vector<MotionPair>& pairs, const GridSpecification& grid,
  const MotionOptions& options = {});

/// A part of a grid: its west, east, south and north faces, in x and y of the grid.
using GridArea = std::array<double, 4>;

/// The one motion of the echo that is in an area of a grid at a time, s since 1970 (Formulas A3),
/// m/s: the displacement that brings the echo of the area in the first images closest to the second
/// images, as EstimateMotion does for each node of a whole grid. It is searched from `first` on,
/// which is known from the echo about the area, by steps of Gauss and Newton on the finest images;
/// without echo in the area it stays `first`. There is at least one pair.
Velocity EstimateMotionWithin(const GridArea& area, double time,
  const std::vector<MotionPair>& pairs, const GridSpecification& grid, const Velocity& first,
  const MotionOptions& options = {});

} // namespace nexrad

// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "nexrad/Motion/MotionEstimate.h"

#include <array>
#include <vector>

namespace nexrad
{

/// A part of a grid: its west, east, south and north faces, in x and y of the grid.
using GridArea = std::array<double, 4>;

/// Two images, and how long before the time at which the echo is in the area the first one was
/// made (below 0: after it), s.
struct AreaPair
{
  MotionPair images;
  double early = 0.0;
};

/// The one motion of the echo that is in an area of a grid at a time (Formulas A3), m/s: the
/// displacement that brings the echo of the area in the first images closest to the second images,
/// as EstimateMotion does for each node of a whole grid. It is searched from `first` on, which is
/// known from the echo about the area, by steps of Gauss and Newton on the finest images; without
/// echo in the area it stays `first`.
Velocity EstimateMotionWithin(const GridArea& area, const std::vector<AreaPair>& pairs,
  const GridSpecification& grid, const Velocity& first, const MotionOptions& options = {});

} // namespace nexrad

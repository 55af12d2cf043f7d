// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "nexrad/Grid/GridSpecification.h"
#include "nexrad/Model/Site.h"

#include <array>
#include <optional>
#include <vector>

namespace nexrad
{

/// Outer faces of a box, degrees.
struct GeographicBounds
{
  double west, south, east, north;
};

/// m, to which the velocity of a weather radar of the network reaches; beyond, beams are too high
/// to show much.
constexpr double DefaultRange = 230'000.0;

/// What a user asks for; the rest follows from the sites.
struct GridRequest
{
  std::array<int, 3> dimensions = {256, 256, 128};
  std::optional<double> range; ///< m, radius of the circle about each site that the box must hold;
                               ///< empty: DefaultRange
  double bottom = 0.0;         ///< m above mean sea level, lower face
  double top = 20'000.0;       ///< m above mean sea level, upper face
  std::optional<GeographicBounds> bounds; ///< replaces the box about the sites
  GridAxes axes = GridAxes::Projected;
};

/// The grid of a request: the box round the circles about all sites (or `bounds`), its centre
/// rounded to 0.01° as the projection's. Throws Error for no sites with a position and no bounds,
/// a lower bound or height above its upper one, dimensions below 1 or more voxels than an int can
/// count, or a range that is not positive.
GridSpecification MakeGrid(const GridRequest& request, const std::vector<Position>& sites);

} // namespace nexrad

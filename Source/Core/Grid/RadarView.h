// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "nexrad/Grid/GridSpecification.h"
#include "nexrad/Model/Site.h"
#include "nexrad/System/RangeLoop.h"

#include <vector>

namespace nexrad
{

/// The voxels of a grid as one radar sees them: where the beam points that passes through a voxel's
/// centre, and how far away the voxel is. Each array has a value for every voxel, x fastest, then
/// y, then z upward.
struct RadarView
{
  std::vector<float> azimuth;    ///< degrees clockwise from north, 0 ≤ azimuth < 360
  std::vector<float> elevation;  ///< degrees above the horizon at the antenna
  std::vector<float> slantRange; ///< m along the beam
};

/// Calls `visit(name, values)` for each array: "azimuth", "elevation" and "slant_range", as images
/// and files name them.
template <class View, class Visit>
void ForEachArray(View& view, const Visit& visit)
{
  visit("azimuth", view.azimuth);
  visit("elevation", view.elevation);
  visit("slant_range", view.slantRange);
}

/// The view of a radar: azimuth and ground distance by the geodesic from its site (Formulas B3),
/// elevation and slant range by the inverse of the beam's path over an earth of 4/3 of its radius
/// (Formulas B2). `loop` runs rows.
RadarView MakeRadarView(
  const GridSpecification& grid, const Position& radar, const RangeLoop& loop = {});

} // namespace nexrad

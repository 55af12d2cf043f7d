// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Scene/Frame/LightOptions.h"
#include "Scene/Frame/SceneFrame.h"
#include "Scene/Map/Elevations.h"

#include <vector>

namespace nexrad::scene
{

/// Heights in m in the middles of equal cells, row by row from the south-western one on.
struct HeightGrid
{
  int columns = 0;
  int rows = 0;
  double cellWidth = 1.0;  ///< km
  double cellHeight = 1.0; ///< km
  std::vector<double> heights;
};

/// The ground under a domain. Cells without elevations have 0 m. Needs HasMap.
HeightGrid MakeHeightGrid(
  const SceneFrame& frame, const Elevations& elevations, int columns, int rows);

/// How much brighter (above 0) or darker each cell is than level ground, -1…1, in light from a
/// direction, with heights stretched so that slopes of 1 in 30 stand out: Lambert's reflection,
/// compressed so that it stays within the bounds.
std::vector<float> ShadeRelief(const HeightGrid& ground, const LightDirection& light);

} // namespace nexrad::scene

// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Scene/Frame/LightOptions.h"
#include "Scene/Frame/SceneFrame.h"
#include "Scene/Map/Elevations.h"
#include "Scene/Shapes/Theme.h"

#include <vtkSmartPointer.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

class vtkImageData;

namespace nexrad::scene
{

class SceneFrame;

/// An area of the map. It lies over those before it.
struct MapArea
{
  bool land = true;                        ///< or water
  std::vector<std::array<double, 2>> ring; ///< longitude and latitude, degrees
};

/// Reads a file of areas (Documentation/Formats/map-lines.md). Throws Error as ParseMapLines does.
std::vector<MapArea> ParseMapAreas(const unsigned char* bytes, std::size_t size);

/// The areas that are compiled in (Data/map_areas.bin): within 16° of each radar. Where there is
/// none there is water.
const std::vector<MapArea>& EmbeddedMapAreas();

/// Which points of the domain are land: `columns` from its western to its eastern edge times `rows`
/// from its southern to its northern one, in the middles of equal cells, row by row. Needs HasMap.
std::vector<std::uint8_t> PaintLand(
  const SceneFrame& frame, const std::vector<MapArea>& areas, int columns, int rows);

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

/// Where a cell of a picture lies among coarser cells: those on both sides of its middle.
struct CellPlace
{
  int before = 0;
  int after = 0;
  float share = 0.0F; ///< of the later one
};

/// The places of all cells along an axis. `part`: of the length of the coarser cells, that which
/// the cells take.
std::vector<CellPlace> PlacesAmong(int cells, int coarser, double part = 1.0);

/// A value of row-by-row cells, `columns` in a row, at a place.
float ValueAt(
  const std::vector<float>& values, int columns, const CellPlace& x, const CellPlace& y);

/// Colours of the ground under a domain, from its south-western corner on: land with shaded relief,
/// and water. A domain outside of the embedded data, or without a map, has one colour. `longSide`:
/// texels along the longer side of the domain.
vtkSmartPointer<vtkImageData> MakeGroundPicture(
  const SceneFrame& frame, const Theme& theme, int longSide = 1024);

} // namespace nexrad::scene

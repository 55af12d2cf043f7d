// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

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

} // namespace nexrad::scene

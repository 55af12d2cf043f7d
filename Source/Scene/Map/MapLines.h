// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace nexrad::scene
{

/// What a line of the map separates.
enum class MapLineKind : std::uint8_t
{
  Country = 0, ///< coasts, shores of lakes, borders of countries
  State = 1,   ///< or province
  County = 2
};

/// A polyline on the map.
struct MapLine
{
  MapLineKind kind = MapLineKind::Country;
  std::vector<std::array<double, 2>> points; ///< longitude and latitude, degrees; at least two
};

/// Reads a file of map lines (Documentation/Formats/map-lines.md). Throws Error, naming the byte
/// offset, for a wrong magic, an unknown kind, a line of fewer than two points, a number that is
/// too large, bytes that end too early or do not end with the last line.
std::vector<MapLine> ParseMapLines(const unsigned char* bytes, std::size_t size);

/// The lines that are compiled in (Data/map_lines.bin): within 8° of each radar.
const std::vector<MapLine>& EmbeddedMapLines();

} // namespace nexrad::scene

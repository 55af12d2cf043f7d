// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <utility>
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

/// A line of the map, or the outline of an area.
struct MapPolyline
{
  std::uint8_t kind = 0; ///< of a line a MapLineKind; of an area 1 for land, 0 for water
  std::vector<std::array<double, 2>> points; ///< longitude and latitude, degrees; at least two
};

/// Reads a file of map lines (Documentation/Formats/map-lines.md). Throws Error, naming the byte
/// offset, for a wrong magic, an unknown kind, a line of fewer than two points, a number that is
/// too large, bytes that end too early or do not end with the last line.
std::vector<MapPolyline> ParseMapLines(const unsigned char* bytes, std::size_t size);

/// The lines that are compiled in (Data/map_lines.bin): within 8° of each radar.
const std::vector<MapPolyline>& EmbeddedMapLines();

/// The areas that are compiled in (Data/map_areas.bin): within 16° of each radar. Each lies over
/// those before it; where there is none there is water.
const std::vector<MapPolyline>& EmbeddedMapAreas();

/// A name on the map.
struct MapName
{
  std::string name;
  double longitude = 0.0; ///< degrees
  double latitude = 0.0;
};

/// Reads lines "name,longitude,latitude" below a heading. Throws Error, naming the line, for one
/// that is none.
std::vector<MapName> ParseMapNames(const std::string& text);

/// The names that are compiled in (Data/map_names.csv): states and territories of the United States
/// and provinces of Canada, each at a point far from its borders.
const std::vector<MapName>& EmbeddedMapNames();

/// The towns that are compiled in (Data/map_towns.csv): those within 8° of each radar, the largest
/// first.
const std::vector<MapName>& EmbeddedTowns();

/// Heights of the ground at the crossings of evenly spaced meridians and parallels, in tiles.
class Elevations
{
public:
  /// Reads a file of elevations (Documentation/Formats/elevations.md). Throws Error, naming the
  /// byte offset, for a wrong magic, sizes of 0 or too large, bytes that end too early, and samples
  /// that are not as many as the tiles need.
  static Elevations Parse(const unsigned char* bytes, std::size_t size);

  /// Metres above mean sea level, 0 at sea, of a place in degrees: cubic B-splines through the 16
  /// samples about it, which smooth them a little. Nothing where one of them is in no tile.
  std::optional<double> At(double longitude, double latitude) const;

private:
  using Corner = std::pair<int, int>; ///< degrees east and north

  std::optional<double> Sample(int column, int row) const;

  int samplesPerDegree = 1;
  int metresPerUnit = 1;
  int tileDegrees = 1;
  std::map<Corner, std::vector<std::int16_t>> tiles;
};

/// Those that are compiled in (Data/elevations.bin): every 5′ within 8° of each radar.
const Elevations& EmbeddedElevations();

} // namespace nexrad::scene

// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace nexrad::scene
{

/// Reads the bytes of a file of the map one after the other. Throws Error, naming the byte offset,
/// for bytes that end too early.
class MapBytes
{
public:
  /// `name`: of the file, for errors.
  MapBytes(const unsigned char* first, std::size_t count, std::string name);

  [[noreturn]] void Fail(const std::string& what) const;

  /// Throws Error when the bytes do not begin so.
  void SkipMagic(const std::string& magic);
  unsigned char Byte();
  /// Seven bits a byte, the lowest first; the top bit says that more follow. Throws Error for a
  /// number of more than 28 bits.
  std::uint32_t Unsigned();
  /// 0, -1, 1, -2, 2, … are stored as 0, 1, 2, 3, 4, …
  std::int32_t Signed();

  std::size_t Remaining() const { return size - offset; }
  /// What was not read yet.
  const unsigned char* Rest() const { return bytes + offset; }

private:
  const unsigned char* bytes;
  std::size_t size;
  std::size_t offset = 0;
  std::string file;
};

/// A line of a file of the map.
struct MapPolyline
{
  std::uint8_t kind = 0;
  std::vector<std::array<double, 2>> points; ///< longitude and latitude, degrees; at least two
};

/// Reads all lines of a file (Documentation/Formats/map-lines.md). `kinds`: how many there are.
/// Throws Error for a kind beyond, a line of fewer than two points, and bytes that do not end with
/// the last line.
std::vector<MapPolyline> ReadMapPolylines(
  MapBytes bytes, const std::string& magic, std::uint8_t kinds);

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

} // namespace nexrad::scene

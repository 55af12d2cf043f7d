// SPDX-License-Identifier: BSD-3-Clause
#include "Scene/Map/MapData.h"

#include "Scene/Shapes/Embedded.h"
#include "nexrad/System/Error.h"

#include <algorithm>
#include <cstddef>
#include <cstring>
#include <locale>
#include <sstream>
#include <utility>

namespace nexrad::scene
{
namespace
{

MapPolyline ReadLine(MapBytes& bytes, std::uint8_t kinds, double degreesPerUnit)
{
  MapPolyline line;
  line.kind = bytes.Byte();
  if (line.kind >= kinds)
  {
    bytes.Fail("unknown kind of line " + std::to_string(line.kind));
  }
  const std::uint32_t count = bytes.Unsigned();
  // A point takes two bytes at least, which bounds the memory by the size of the file.
  if (count < 2 || count > bytes.Remaining() / 2)
  {
    bytes.Fail("a line of " + std::to_string(count) + " points");
  }
  line.points.reserve(count);
  std::int64_t x = 0;
  std::int64_t y = 0;
  for (std::uint32_t i = 0; i < count; ++i)
  {
    x += bytes.Signed();
    y += bytes.Signed();
    line.points.push_back(
      {static_cast<double>(x) * degreesPerUnit, static_cast<double>(y) * degreesPerUnit});
  }
  return line;
}

} // namespace

MapBytes::MapBytes(const unsigned char* first, std::size_t count, std::string name)
  : bytes(first)
  , size(count)
  , file(std::move(name))
{
}

void MapBytes::Fail(const std::string& what) const
{
  throw Error(file + ": offset " + std::to_string(offset) + ": " + what);
}

void MapBytes::SkipMagic(const std::string& magic)
{
  if (size < magic.size() || std::memcmp(bytes, magic.data(), magic.size()) != 0)
  {
    this->Fail("the file does not begin with " + magic.substr(0, magic.size() - 1));
  }
  offset = magic.size();
}

unsigned char MapBytes::Byte()
{
  if (offset == size)
  {
    this->Fail("the file ends too early");
  }
  return bytes[offset++];
}

std::uint32_t MapBytes::Unsigned()
{
  std::uint32_t value = 0;
  for (int shift = 0; shift < 28; shift += 7)
  {
    const unsigned char byte = this->Byte();
    value |= static_cast<std::uint32_t>(byte & 0x7f) << shift;
    if ((byte & 0x80) == 0)
    {
      return value;
    }
  }
  this->Fail("a number has more than 28 bits");
}

std::int32_t MapBytes::Signed()
{
  const std::uint32_t stored = this->Unsigned();
  const auto half = static_cast<std::int32_t>(stored >> 1);
  return (stored & 1) != 0 ? -half - 1 : half;
}

std::vector<MapPolyline> ReadMapPolylines(
  MapBytes bytes, const std::string& magic, std::uint8_t kinds)
{
  bytes.SkipMagic(magic);
  const std::uint32_t unitsPerDegree = bytes.Unsigned();
  if (unitsPerDegree == 0)
  {
    bytes.Fail("no units in a degree");
  }
  const std::uint32_t count = bytes.Unsigned();
  std::vector<MapPolyline> lines;
  lines.reserve(std::min<std::size_t>(count, bytes.Remaining() / 6));
  for (std::uint32_t i = 0; i < count; ++i)
  {
    lines.push_back(ReadLine(bytes, kinds, 1.0 / unitsPerDegree));
  }
  if (bytes.Remaining() != 0)
  {
    bytes.Fail("bytes after the last line");
  }
  return lines;
}

std::vector<MapLine> ParseMapLines(const unsigned char* bytes, std::size_t size)
{
  constexpr std::uint8_t kinds = 3;
  std::vector<MapLine> lines;
  for (MapPolyline& line : ReadMapPolylines(MapBytes(bytes, size, "map lines"), "NXMAP1\n", kinds))
  {
    lines.push_back({static_cast<MapLineKind>(line.kind), std::move(line.points)});
  }
  return lines;
}

const std::vector<MapLine>& EmbeddedMapLines()
{
  static const std::vector<MapLine> lines =
    ParseMapLines(embedded::mapLines, embedded::mapLinesSize);
  return lines;
}

std::vector<MapName> ParseMapNames(const std::string& text)
{
  std::vector<MapName> names;
  std::istringstream lines(text);
  std::string line;
  std::getline(lines, line); // the heading
  for (int number = 2; std::getline(lines, line); ++number)
  {
    MapName name;
    const std::size_t comma = line.find(',');
    name.name = line.substr(0, comma);
    std::istringstream place(comma == std::string::npos ? "" : line.substr(comma + 1));
    place.imbue(std::locale::classic());
    char separator = '\0';
    place >> name.longitude >> separator >> name.latitude;
    if (!place || name.name.empty() || separator != ',' || !(place >> std::ws).eof())
    {
      throw Error("map names: line " + std::to_string(number) + ": '" + line +
                  "' must hold a name, a longitude and a latitude");
    }
    names.push_back(name);
  }
  return names;
}

const std::vector<MapName>& EmbeddedMapNames()
{
  static const std::vector<MapName> names =
    ParseMapNames(std::string(embedded::mapNames, embedded::mapNames + embedded::mapNamesSize));
  return names;
}

const std::vector<MapName>& EmbeddedTowns()
{
  static const std::vector<MapName> towns =
    ParseMapNames(std::string(embedded::mapTowns, embedded::mapTowns + embedded::mapTownsSize));
  return towns;
}

} // namespace nexrad::scene

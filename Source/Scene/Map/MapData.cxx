// SPDX-License-Identifier: BSD-3-Clause
#include "Scene/Map/MapData.h"

#include "Scene/Shapes/Embedded.h"
#include "nexrad/Compression/Deflate.h"
#include "nexrad/System/Error.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <locale>
#include <sstream>

namespace nexrad::scene
{
namespace
{

// Reads the bytes of a file one after the other. Throws Error, naming the byte offset, for bytes
// that end too early.
class MapBytes
{
public:
  // `name`: of the file, for errors.
  MapBytes(const unsigned char* first, std::size_t count, std::string name)
    : bytes(first)
    , size(count)
    , file(std::move(name))
  {
  }

  [[noreturn]] void Fail(const std::string& what) const
  {
    throw Error(file + ": offset " + std::to_string(offset) + ": " + what);
  }

  void SkipMagic(const std::string& magic)
  {
    if (size < magic.size() || std::memcmp(bytes, magic.data(), magic.size()) != 0)
    {
      this->Fail("the file does not begin with " + magic.substr(0, magic.size() - 1));
    }
    offset = magic.size();
  }

  unsigned char Byte()
  {
    if (offset == size)
    {
      this->Fail("the file ends too early");
    }
    return bytes[offset++];
  }

  // Seven bits a byte, the lowest first; the top bit says that more follow.
  std::uint32_t Unsigned()
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

  // 0, -1, 1, -2, 2, … are stored as 0, 1, 2, 3, 4, …
  std::int32_t Signed()
  {
    const std::uint32_t stored = this->Unsigned();
    const auto half = static_cast<std::int32_t>(stored >> 1);
    return (stored & 1) != 0 ? -half - 1 : half;
  }

  std::size_t Remaining() const { return size - offset; }
  // What was not read yet.
  const unsigned char* Rest() const { return bytes + offset; }

private:
  const unsigned char* bytes;
  std::size_t size;
  std::size_t offset = 0;
  std::string file;
};

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

// All lines of a file (Documentation/Formats/map-lines.md), of so many kinds.
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

} // namespace

std::vector<MapPolyline> ParseMapLines(const unsigned char* bytes, std::size_t size)
{
  return ReadMapPolylines(MapBytes(bytes, size, "map lines"), "NXMAP1\n", 3);
}

const std::vector<MapPolyline>& EmbeddedMapLines()
{
  static const std::vector<MapPolyline> lines =
    ParseMapLines(embedded::mapLines, embedded::mapLinesSize);
  return lines;
}

const std::vector<MapPolyline>& EmbeddedMapAreas()
{
  static const std::vector<MapPolyline> areas = ReadMapPolylines(
    MapBytes(embedded::mapAreas, embedded::mapAreasSize, "map areas"), "NXAREA1\n", 2);
  return areas;
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

namespace
{

constexpr char elevationFile[] = "elevations";

int FloorDivide(int value, int by)
{
  return value >= 0 ? value / by : -((by - 1 - value) / by);
}

std::uint32_t ReadBetween(
  MapBytes& bytes, std::uint32_t least, std::uint32_t most, const char* what)
{
  const std::uint32_t value = bytes.Unsigned();
  if (value < least || value > most)
  {
    bytes.Fail(std::to_string(value) + " " + what);
  }
  return value;
}

std::vector<std::uint8_t> Inflate(MapBytes& bytes, std::size_t samples)
{
  // A sample takes one to four bytes.
  const std::uint32_t size = bytes.Unsigned();
  if (size < samples || size > 4 * samples)
  {
    bytes.Fail(std::to_string(size) + " bytes of samples for " + std::to_string(samples));
  }
  std::vector<std::uint8_t> target(size);
  try
  {
    InflateBytes(bytes.Rest(), bytes.Remaining(), target.data(), target.size());
  }
  catch (const Error& error)
  {
    bytes.Fail(error.what());
  }
  return target;
}

// Each sample is a step from what those to the west, to the south and between them let expect.
std::vector<std::int16_t> ReadTile(MapBytes& bytes, int side)
{
  std::vector<std::int16_t> tile;
  tile.reserve(static_cast<std::size_t>(side) * side);
  const auto at = [&](int column, int row) -> std::int64_t
  { return column < 0 || row < 0 ? 0 : tile[static_cast<std::size_t>(row) * side + column]; };
  for (int row = 0; row < side; ++row)
  {
    for (int column = 0; column < side; ++column)
    {
      const std::int64_t value =
        bytes.Signed() + at(column - 1, row) + at(column, row - 1) - at(column - 1, row - 1);
      if (value < 0 || value > std::numeric_limits<std::int16_t>::max())
      {
        bytes.Fail("a height of " + std::to_string(value) + " units");
      }
      tile.push_back(static_cast<std::int16_t>(value));
    }
  }
  return tile;
}

// Weights of four samples for a place a fraction behind the second of them.
std::array<double, 4> BSplineWeights(double t)
{
  const double u = 1.0 - t;
  return {u * u * u / 6.0, (4.0 + t * t * (3.0 * t - 6.0)) / 6.0,
    (4.0 + u * u * (3.0 * u - 6.0)) / 6.0, t * t * t / 6.0};
}

} // namespace

Elevations Elevations::Parse(const unsigned char* bytes, std::size_t size)
{
  MapBytes head(bytes, size, elevationFile);
  head.SkipMagic("NXELEV1\n");
  Elevations result;
  result.samplesPerDegree = static_cast<int>(ReadBetween(head, 1, 120, "samples in a degree"));
  result.metresPerUnit = static_cast<int>(ReadBetween(head, 1, 1000, "metres in a unit"));
  result.tileDegrees = static_cast<int>(ReadBetween(head, 1, 30, "degrees in a tile"));
  const std::uint32_t count = ReadBetween(head, 0, 64'800, "tiles");
  std::vector<Corner> corners;
  for (std::uint32_t i = 0; i < count; ++i)
  {
    const int west = head.Signed();
    corners.emplace_back(west, head.Signed());
  }
  const int side = result.tileDegrees * result.samplesPerDegree;
  const std::vector<std::uint8_t> inflated =
    Inflate(head, count * static_cast<std::size_t>(side) * static_cast<std::size_t>(side));
  MapBytes samples(inflated.data(), inflated.size(), std::string(elevationFile) + ": samples");
  for (const Corner& corner : corners)
  {
    result.tiles[corner] = ReadTile(samples, side);
  }
  if (samples.Remaining() != 0)
  {
    samples.Fail("bytes after the last tile");
  }
  return result;
}

std::optional<double> Elevations::Sample(int column, int row) const
{
  const int side = tileDegrees * samplesPerDegree;
  const int worldTiles = 360 / tileDegrees;
  const int tileColumn = FloorDivide(column, side);
  const int tileRow = FloorDivide(row, side);
  const int around = FloorDivide(tileColumn + worldTiles / 2, worldTiles) * worldTiles;
  const auto tile = tiles.find({(tileColumn - around) * tileDegrees, tileRow * tileDegrees});
  if (tile == tiles.end())
  {
    return std::nullopt;
  }
  const int within = (row - tileRow * side) * side + column - tileColumn * side;
  return metresPerUnit * static_cast<double>(tile->second[static_cast<std::size_t>(within)]);
}

std::optional<double> Elevations::At(double longitude, double latitude) const
{
  const double x = longitude * samplesPerDegree;
  const double y = latitude * samplesPerDegree;
  const int column = static_cast<int>(std::floor(x));
  const int row = static_cast<int>(std::floor(y));
  const auto acrossX = BSplineWeights(x - column);
  const auto acrossY = BSplineWeights(y - row);
  double sum = 0.0;
  for (int j = 0; j < 4; ++j)
  {
    for (int i = 0; i < 4; ++i)
    {
      const auto sample = this->Sample(column + i - 1, row + j - 1);
      if (!sample)
      {
        return std::nullopt;
      }
      sum += acrossX[static_cast<std::size_t>(i)] * acrossY[static_cast<std::size_t>(j)] * *sample;
    }
  }
  return sum;
}

const Elevations& EmbeddedElevations()
{
  static const Elevations all = Elevations::Parse(embedded::elevations, embedded::elevationsSize);
  return all;
}

} // namespace nexrad::scene

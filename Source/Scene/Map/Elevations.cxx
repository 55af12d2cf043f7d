// SPDX-License-Identifier: BSD-3-Clause
#include "Scene/Map/Elevations.h"

#include "Scene/Map/MapData.h"
#include "Scene/Shapes/Embedded.h"
#include "nexrad/Compression/Deflate.h"
#include "nexrad/System/Error.h"

#include <array>
#include <cmath>
#include <limits>

namespace nexrad::scene
{
namespace
{

constexpr char fileName[] = "elevations";

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
  MapBytes head(bytes, size, fileName);
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
  MapBytes samples(inflated.data(), inflated.size(), std::string(fileName) + ": samples");
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

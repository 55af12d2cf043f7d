// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <utility>
#include <vector>

namespace nexrad::scene
{

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

// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "nexrad/Grid/GriddedVolume.h"

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

namespace nexrad::application
{

/// The codes of a volume as a page holds them, before they are deflated
/// (Documentation/Formats/web-page.md). Echo is found column by column; most columns have a few
/// layers of it, and a code is mostly that of the voxel below.
struct PackedColumns
{
  std::vector<std::uint8_t> ends;  ///< where echo begins and ends in each column
  std::vector<std::uint8_t> codes; ///< of the voxels with echo, as differences
};

/// Largest number of layers of a volume that can be packed: an end is a byte.
constexpr int MostPackedLayers = 254;

/// Packs a code for each voxel (x fastest, then y, then z upward); 0 stands for no echo. Throws
/// Error for more than MostPackedLayers layers.
PackedColumns PackColumns(const std::array<int, 3>& size, const std::vector<std::uint8_t>& codes);

/// How a page holds the values of a moment. Its textures have a byte for each voxel: `first` +
/// `step` × byte. The volumes in the page have fewer codes, each of which stands for one byte; 0 is
/// no echo.
struct PageCode
{
  double first = 0.0;  ///< unit of the moment; the value of byte 0
  double step = 0.5;   ///< unit of the moment, from one byte to the next
  bool masked = false; ///< whether byte 0 is no value, in place of `first`: all moments but REF
  std::optional<double> floor; ///< echo below this value is kept next to stronger echo alone, and
                               ///< coarsely; empty: all echo is kept alike
  std::vector<std::uint8_t> bytes; ///< of each code, 1 to 256 of them

  /// The code of reflectivity in a volume: steps of 2 dBZ from the floor on. The floor is
  /// `leastVisible` in dBZ, the least value that any preset of the page shows, or up to half a dBZ
  /// below it.
  static PageCode OfReflectivity(const GriddedVolume& volume, double leastVisible);
  /// The code of another moment, 127 steps between two values.
  static PageCode OfRange(const std::array<double, 2>& range);

  double ValueOf(std::uint8_t byte) const { return first + step * byte; }
  /// The byte that stands for a value, without rounding.
  double ByteOf(double value) const { return (value - first) / step; }

  /// The codes of all voxels of a volume, for PackColumns.
  std::vector<std::uint8_t> Encode(const GriddedVolume& volume) const;
};

} // namespace nexrad::application

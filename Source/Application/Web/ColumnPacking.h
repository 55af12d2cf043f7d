// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstdint>
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
/// Error when there are not as many codes as voxels, and for more than MostPackedLayers layers.
PackedColumns PackColumns(const std::array<int, 3>& size, const std::vector<std::uint8_t>& codes);

} // namespace nexrad::application

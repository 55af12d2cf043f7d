// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "VolumeMaker.h"
#include "VolumePart.h"
#include "nexrad/Codec/NxvFile.h"

#include <algorithm>
#include <array>
#include <filesystem>
#include <optional>
#include <random>

namespace nexrad::testing
{

/// Blocks of one state, echo among them that changes from voxel to voxel, and single voxels of
/// other states. Another `seed` makes other blocks and voxels.
inline GriddedVolume MakeMixedVolume(
  MomentName moment, const std::array<int, 3>& dimensions, int seed = 0)
{
  GriddedVolume volume = MakeGriddedVolume(dimensions);
  volume.moment = moment;
  std::mt19937 random(static_cast<unsigned>(moment) + 5U + 100U * static_cast<unsigned>(seed));
  std::uniform_int_distribution<int> hundred(0, 99);
  std::size_t i = 0;
  for (int z = 0; z < dimensions[2]; ++z)
  {
    for (int y = 0; y < dimensions[1]; ++y)
    {
      for (int x = 0; x < dimensions[0]; ++x, ++i)
      {
        const int place = x / 9 + y / 5 + z / 4 + seed;
        const int chance = hundred(random);
        volume.states[i] = chance == 0                    ? VoxelState::RangeFolded
                           : chance == 1                  ? VoxelState::Filtered
                           : place % 3 == 0 || chance < 5 ? VoxelState::NotScanned
                           : place % 3 == 1               ? VoxelState::NoEcho
                                                          : VoxelState::Echo;
        volume.values[i] = volume.states[i] == VoxelState::Echo
                             ? static_cast<float>(hundred(random)) / 2.0F
                             : volume.fill;
      }
    }
  }
  return volume;
}

/// The band of a grid that begins with a row.
inline VoxelBlock RowsFrom(const GridSpecification& grid, int row)
{
  VoxelBlock rows = VoxelBlock::Of(grid);
  rows.begin[1] = row;
  rows.end[1] = std::min(row + NxvBandWriter::Rows, grid.dimensions[1]);
  return rows;
}

/// Writes a volume in bricks, band by band.
inline void WriteBricks(const std::filesystem::path& path, const GriddedVolume& volume,
  std::optional<NxvEncoding> encoding = {})
{
  NxvBandWriter writer(path, volume.grid, encoding);
  for (int row = 0; row < volume.grid.dimensions[1]; row += NxvBandWriter::Rows)
  {
    writer.Add(TakePart(volume, RowsFrom(volume.grid, row)), ThreadLoop(2));
  }
  writer.Commit();
}

} // namespace nexrad::testing

// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "VolumePart.h"
#include "nexrad/Codec/NxvFile.h"

#include <algorithm>
#include <filesystem>
#include <optional>

namespace nexrad::testing
{

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

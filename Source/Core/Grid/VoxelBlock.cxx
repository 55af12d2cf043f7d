// SPDX-License-Identifier: BSD-3-Clause
#include "nexrad/Grid/VoxelBlock.h"

#include "nexrad/System/Error.h"

#include <algorithm>
#include <string>

namespace nexrad
{

VoxelBlock VoxelBlock::Of(const GridSpecification& grid)
{
  VoxelBlock block;
  block.end = grid.dimensions;
  return block;
}

std::size_t VoxelBlock::VoxelCount() const
{
  std::size_t count = 1;
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    count *= static_cast<std::size_t>(std::max(0, this->Size(axis)));
  }
  return count;
}

VoxelBlock VoxelBlock::Columns(const GridSpecification& grid) const
{
  VoxelBlock columns = *this;
  columns.begin[2] = 0;
  columns.end[2] = grid.dimensions[2];
  return columns;
}

bool operator==(const VoxelBlock& a, const VoxelBlock& b)
{
  return a.begin == b.begin && a.end == b.end;
}

GridSpecification PartOf(const GridSpecification& grid, const VoxelBlock& block)
{
  GridSpecification part = grid;
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    if (block.begin[axis] < 0 || block.Size(axis) < 1 || block.end[axis] > grid.dimensions[axis])
    {
      throw Error("voxels " + std::to_string(block.begin[axis]) + " to " +
                  std::to_string(block.end[axis] - 1) + " along axis " + std::to_string(axis) +
                  " of a grid that has " + std::to_string(grid.dimensions[axis]) +
                  ": a block needs a voxel or more, all in the grid");
    }
    part.dimensions[axis] = block.Size(axis);
    part.origin[axis] = grid.Coordinate(static_cast<int>(axis), block.begin[axis]);
  }
  return part;
}

} // namespace nexrad

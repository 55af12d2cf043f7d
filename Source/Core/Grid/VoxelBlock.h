// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "nexrad/Grid/GridSpecification.h"

#include <array>
#include <cstddef>

namespace nexrad
{

/// A box of voxels of a grid: those of which each index lies in begin ≤ index < end.
struct VoxelBlock
{
  std::array<int, 3> begin = {0, 0, 0}; ///< along x, y, z
  std::array<int, 3> end = {0, 0, 0};

  /// All voxels of a grid.
  static VoxelBlock Of(const GridSpecification& grid);

  int Size(std::size_t axis) const { return end[axis] - begin[axis]; }
  std::size_t VoxelCount() const;
  /// The whole columns of the grid that the block has voxels of.
  VoxelBlock Columns(const GridSpecification& grid) const;
};

bool operator==(const VoxelBlock& a, const VoxelBlock& b);
inline bool operator!=(const VoxelBlock& a, const VoxelBlock& b)
{
  return !(a == b);
}

/// The block as a grid of its own. Throws Error when the block has no voxels, or some outside the
/// grid.
GridSpecification PartOf(const GridSpecification& grid, const VoxelBlock& block);

} // namespace nexrad

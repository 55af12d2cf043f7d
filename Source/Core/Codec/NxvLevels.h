// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "nexrad/Grid/GriddedVolume.h"
#include "nexrad/System/RangeLoop.h"

#include <array>
#include <vector>

namespace nexrad
{

/// Voxels along x, y and z that one voxel of a coarser grid takes the place of; each 1 or more.
using VoxelsInOne = std::array<int, 3>;

/// The grid of voxels that are so many times as large. At its upper faces it may reach beyond the
/// finer grid, by less than one of its voxels.
GridSpecification CoarserGrid(const GridSpecification& grid, const VoxelsInOne& voxels);

/// The levels that are stored beside a grid, from fine to coarse, by how many of its voxels each of
/// theirs takes the place of. Each level halves the one before along x and y, and along z while
/// that has more than 32 layers, for pictures exaggerate heights. The last one has at most 512
/// voxels along x and y.
std::vector<VoxelsInOne> CoarserLevels(const GridSpecification& grid);

/// Voxels of one level in one of a coarser level.
VoxelsInOne VoxelsBetween(const VoxelsInOne& fine, const VoxelsInOne& coarse);

/// A volume of a grid with the moments of another one, all of its voxels not scanned.
GriddedVolume VolumeLike(const GriddedVolume& volume, const GridSpecification& grid);

/// Sets voxels of a coarser volume (Formulas G14), not scanned until then, from those that they
/// take the place of. The rows of `fine` are those of its grid that the rows of `coarse` from `row`
/// on stand for. Ancillary arrays are left out.
void SetCoarser(const GriddedVolume& fine, const VoxelsInOne& voxels, int row,
  GriddedVolume& coarse, const RangeLoop& loop = {});

} // namespace nexrad

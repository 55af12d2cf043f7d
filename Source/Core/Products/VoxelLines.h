// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "nexrad/Grid/GriddedVolume.h"
#include "nexrad/Products/GroundHeight.h"
#include "nexrad/System/RangeLoop.h"

#include <cstddef>
#include <functional>

namespace nexrad
{

/// The voxels of one moment on a grid, however they are stored: what is computed of whole columns
/// reads them a stretch at a time, without a copy of the volume.
struct VoxelLines
{
  GridSpecification grid;
  MomentName moment = MomentName::REF;
  /// Writes the values and states of `count` voxels from the index `first` on (x fastest, then y,
  /// then z). Values of voxels without an echo have no meaning. Several threads may call it.
  std::function<void(std::size_t first, std::size_t count, float* values, VoxelState* states)> read;
  GroundHeight ground = {}; ///< below the columns; sea level where no radar is known
};

/// Those of a volume, which must outlive them.
VoxelLines LinesOf(const GriddedVolume& volume);

/// A stretch of neighbouring columns at one level.
struct ColumnStretch
{
  std::size_t first = 0; ///< column: x fastest, then y
  std::size_t count = 0;
  int level = 0;
  const float* values = nullptr;      ///< `count` of them, as VoxelLines::read has them
  const VoxelState* states = nullptr; ///< likewise
};

/// Visits all voxels. Each column is visited by one thread, from its lowest level up; the levels
/// from `first` to before `last` are visited.
void WalkColumns(const VoxelLines& voxels, int first, int last, const RangeLoop& loop,
  const std::function<void(const ColumnStretch& stretch)>& visit);

} // namespace nexrad

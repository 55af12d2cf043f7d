// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "nexrad/Grid/GridSpecification.h"
#include "nexrad/Grid/GriddedVolume.h"
#include "nexrad/Model/Site.h"
#include "nexrad/System/RangeLoop.h"

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

namespace nexrad
{

/// The height of the ground below the columns of a grid, as far as the radars of a volume tell it:
/// that of the ground at the radar nearest to a column.
class GroundHeight
{
public:
  /// Mean sea level everywhere.
  GroundHeight() = default;
  /// From the radars of a volume. The site table has the ground at a radar that it knows; of
  /// another one the height of the antenna in `positions` stands for it. `positions` are those of
  /// `sites` in their order, or empty.
  GroundHeight(const GridSpecification& grid, const std::vector<std::string>& sites,
    const std::vector<Position>& positions);

  /// m above mean sea level, below a column of the grid (x fastest, then y); 0 where no radar's
  /// place is known.
  double Below(const GridSpecification& grid, std::size_t column) const;

private:
  struct Place
  {
    double x; // of the grid
    double y;
    double height; // m above mean sea level
  };
  std::vector<Place> places;
};

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

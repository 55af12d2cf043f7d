// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "nexrad/Grid/GridSpecification.h"

#include <array>
#include <cstddef>
#include <vector>

namespace nexrad
{

/// How far echo moves in a second, m/s towards east (+x) and north (+y) of the grid.
struct Velocity
{
  double east = 0.0;
  double north = 0.0;
};

/// m/s: no motion that is given may be faster.
constexpr double FastestEcho = 150.0;

/// Width and depth in m of the voxels in a row of a grid; on geographic axes the width shrinks
/// towards the poles. The row may be a fraction.
std::array<double, 2> VoxelExtent(const GridSpecification& grid, double row);

/// A coarse lattice of nodes over the columns and rows of a grid, its first node at voxel (0, 0),
/// its last at the last voxel.
struct MotionLattice
{
  std::array<int, 2> nodes = {1, 1};       ///< along x and y, at least 1
  std::array<double, 2> step = {1.0, 1.0}; ///< voxels between nodes

  /// Four nodes about a place and their shares in it (bilinear; they sum to 1). A place outside the
  /// lattice counts as the nearest on its border.
  struct Corners
  {
    std::array<std::size_t, 4> node = {};
    std::array<double, 4> share = {};
  };
  Corners Around(double column, double row) const;

  std::size_t NodeCount() const
  {
    return static_cast<std::size_t>(nodes[0]) * static_cast<std::size_t>(nodes[1]);
  }
};

/// The lattice whose nodes lie at most `spacing` m apart. Throws Error when the spacing is not
/// positive or the grid has no voxels.
MotionLattice MakeMotionLattice(const GridSpecification& grid, double spacing);

/// Horizontal motion of the echo over a grid, the same at all heights: bilinear between the nodes.
struct MotionField
{
  MotionLattice lattice;
  std::vector<Velocity> velocities = {Velocity{}}; ///< at the nodes, x fastest

  /// The same motion everywhere, on any grid.
  static MotionField Constant(const Velocity& velocity) { return {MotionLattice{}, {velocity}}; }

  /// Motion at a voxel; fractions count.
  Velocity At(double column, double row) const;

  /// m/s, of the fastest node.
  double FastestSpeed() const;
  /// The same of the nodes about the columns of a block: nothing moves faster there.
  double FastestSpeedIn(const VoxelBlock& block) const;
  /// True when it reaches over the columns and rows of a grid: a constant one over any, another
  /// when its last nodes stand at the last voxels.
  bool Covers(const GridSpecification& grid) const;
};

} // namespace nexrad

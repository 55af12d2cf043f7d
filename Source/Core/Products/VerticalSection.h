// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "nexrad/Grid/GriddedVolume.h"

#include <array>
#include <cstddef>
#include <functional>
#include <vector>

namespace nexrad
{

/// A straight line on the ground, in x and y of a grid.
struct SectionLine
{
  std::array<double, 2> from = {0.0, 0.0}; ///< the end A: m, or degrees for Geographic axes
  std::array<double, 2> to = {0.0, 0.0};   ///< the end B

  bool operator==(const SectionLine& other) const { return from == other.from && to == other.to; }
};

/// Where the samples of a section lie, and what they are of.
struct SectionSampling
{
  SectionLine line;
  std::array<int, 2> dimensions = {512, 256}; ///< samples along the line and upwards; above 0
  MomentName moment = MomentName::REF;
};

/// The voxels of a grid, x fastest, then y, then z upward, however they are stored.
struct VoxelSource
{
  std::function<VoxelState(std::size_t)> state;
  std::function<float(std::size_t)> value; ///< is asked for voxels with an echo alone
};

/// What stands above a line. The samples are the centres of rectangles that fill the section.
struct VerticalSection
{
  std::array<int, 2> dimensions = {0, 0};
  double length = 0.0; ///< m along the ground from A to B: of Geographic axes that of the geodesic
  double bottom = 0.0, top = 0.0; ///< m above mean sea level: the lower and upper face of the grid
  std::vector<float> values;      ///< along the line fastest, then upward; NaN without an echo
  std::vector<VoxelState> states;
};

/// The section of a grid from its lower to its upper face. Points outside of the grid are not
/// scanned. Of velocities, which are folded, and of phases, whose 0 and 360 degrees are one, a
/// point has what the voxel has in which it lies: averages mean nothing. Of other moments it is
/// interpolated linearly, as formula G6 has it: where voxels that were not scanned, are range
/// folded or filtered hold at least half of the weight, the point has the one of these states that
/// holds most of it; else, where voxels without echo hold at least half of the rest, it has no
/// echo; else it has the mean of the voxels with an echo alone. So no value is mixed with a missing
/// one.
VerticalSection MakeVerticalSection(
  const GridSpecification& grid, const VoxelSource& voxels, const SectionSampling& sampling);

} // namespace nexrad

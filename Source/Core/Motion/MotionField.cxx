// SPDX-License-Identifier: BSD-3-Clause
#include "nexrad/Motion/MotionField.h"

#include "nexrad/Geometry/Angles.h"
#include "nexrad/System/Error.h"

#include <algorithm>
#include <cmath>

namespace nexrad
{

namespace
{

// Where a place lies between two nodes of one axis.
struct Between
{
  std::size_t low = 0;
  std::size_t high = 0;
  double share = 0.0; // of `high`
};

Between Locate(double voxel, double step, int nodes)
{
  const double place = std::clamp(voxel / step, 0.0, static_cast<double>(nodes - 1));
  const auto low = static_cast<std::size_t>(place);
  const std::size_t high = std::min(low + 1, static_cast<std::size_t>(nodes - 1));
  return {low, high, place - static_cast<double>(low)};
}

} // namespace

std::array<double, 2> VoxelExtent(const GridSpecification& grid, double row)
{
  if (grid.axes == GridAxes::Projected)
  {
    return {grid.spacing[0], grid.spacing[1]};
  }
  // A sphere is good to half a percent, far better than motion is known.
  constexpr double narrowest = 1e-3; // keeps a grid that touches a pole from voxels without width
  const double latitude = grid.origin[1] + grid.spacing[1] * row;
  const double narrowing = std::max(std::cos(latitude * RadiansPerDegree), narrowest);
  return {grid.spacing[0] * MetresPerDegree * narrowing, grid.spacing[1] * MetresPerDegree};
}

MotionLattice::Corners MotionLattice::Around(double column, double row) const
{
  const Between x = Locate(column, step[0], nodes[0]);
  const Between y = Locate(row, step[1], nodes[1]);
  const auto width = static_cast<std::size_t>(nodes[0]);
  Corners corners;
  corners.node = {
    y.low * width + x.low, y.low * width + x.high, y.high * width + x.low, y.high * width + x.high};
  corners.share = {(1.0 - y.share) * (1.0 - x.share), (1.0 - y.share) * x.share,
    y.share * (1.0 - x.share), y.share * x.share};
  return corners;
}

MotionLattice MakeMotionLattice(const GridSpecification& grid, double spacing)
{
  if (!(spacing > 0.0))
  {
    throw Error("motion: the nodes must be more than 0 m apart");
  }
  if (grid.VoxelCount() == 0)
  {
    throw Error("motion: the grid has no voxels: each dimension must be 1 or more");
  }
  const double middleRow = 0.5 * (grid.dimensions[1] - 1);
  const std::array<double, 2> extent = VoxelExtent(grid, middleRow);
  MotionLattice lattice;
  for (std::size_t axis = 0; axis < 2; ++axis)
  {
    const int last = grid.dimensions[axis] - 1;
    // More nodes than voxels would know nothing more.
    const double intervals =
      std::min(std::ceil(last * extent[axis] / spacing), static_cast<double>(last));
    lattice.nodes[axis] = static_cast<int>(intervals) + 1;
    lattice.step[axis] = last > 0 ? last / intervals : 1.0;
  }
  return lattice;
}

Velocity MotionField::At(double column, double row) const
{
  const MotionLattice::Corners corners = lattice.Around(column, row);
  Velocity sum;
  for (std::size_t i = 0; i < corners.node.size(); ++i)
  {
    const Velocity& node = velocities[corners.node[i]];
    sum.east += corners.share[i] * node.east;
    sum.north += corners.share[i] * node.north;
  }
  return sum;
}

double MotionField::FastestSpeed() const
{
  double fastest = 0.0;
  for (const Velocity& velocity : velocities)
  {
    fastest = std::max(fastest, std::hypot(velocity.east, velocity.north));
  }
  return fastest;
}

double MotionField::FastestSpeedIn(const VoxelBlock& block) const
{
  std::array<std::size_t, 2> first{};
  std::array<std::size_t, 2> last{};
  for (std::size_t axis = 0; axis < 2; ++axis)
  {
    const auto node = [&](double place)
    {
      return static_cast<std::size_t>(
        std::clamp(place, 0.0, static_cast<double>(lattice.nodes[axis] - 1)));
    };
    first[axis] = node(std::floor(block.begin[axis] / lattice.step[axis]));
    last[axis] = node(std::ceil((block.end[axis] - 1) / lattice.step[axis]));
  }
  double fastest = 0.0;
  for (std::size_t y = first[1]; y <= last[1]; ++y)
  {
    for (std::size_t x = first[0]; x <= last[0]; ++x)
    {
      const Velocity& velocity = velocities[y * static_cast<std::size_t>(lattice.nodes[0]) + x];
      fastest = std::max(fastest, std::hypot(velocity.east, velocity.north));
    }
  }
  return fastest;
}

bool MotionField::Covers(const GridSpecification& grid) const
{
  if (velocities.size() != lattice.NodeCount())
  {
    return false;
  }
  bool covers = true;
  for (std::size_t axis = 0; axis < 2; ++axis)
  {
    const double reach = lattice.step[axis] * (lattice.nodes[axis] - 1);
    covers = covers && std::abs(reach - (grid.dimensions[axis] - 1)) < 0.5;
  }
  return covers || velocities.size() == 1;
}

} // namespace nexrad

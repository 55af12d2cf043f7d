// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "nexrad/Grid/GriddedVolume.h"

#include <functional>

namespace nexrad::testing
{

/// A grid of voxels of `spacing` m, its first voxel's centre at x = y = 0.
inline GridSpecification MakeTestGrid(const std::array<int, 3>& dimensions, double spacing)
{
  GridSpecification grid;
  grid.dimensions = dimensions;
  grid.spacing = {spacing, spacing, 500.0};
  return grid;
}

/// A volume whose voxels are what a function of x and y in m says in dBZ; 0 or less is no echo.
inline GriddedVolume MakeTestVolume(const GridSpecification& grid, Time time,
  const std::function<double(double x, double y)>& reflectivity)
{
  GriddedVolume volume;
  volume.grid = grid;
  volume.time = time;
  volume.method = "test";
  for (int z = 0; z < grid.dimensions[2]; ++z)
  {
    for (int y = 0; y < grid.dimensions[1]; ++y)
    {
      for (int x = 0; x < grid.dimensions[0]; ++x)
      {
        const auto value =
          static_cast<float>(reflectivity(grid.Coordinate(0, x), grid.Coordinate(1, y)));
        volume.values.push_back(value > 0.0F ? value : volume.fill);
        volume.states.push_back(value > 0.0F ? VoxelState::Echo : VoxelState::NoEcho);
      }
    }
  }
  return volume;
}

} // namespace nexrad::testing

// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "nexrad/Grid/GridSpecification.h"
#include "nexrad/Simulation/StormField.h"

#include <vector>

namespace nexrad::testing
{

/// Means of a storm field over the boxes of voxels (of dBZ floored at `floor`, over a fixed lattice
/// of 4 × 4 × 2 samples), dBZ: those of the rows [beginRow, endRow) of a grid, all columns and
/// heights. The value of voxel (x, y, z) is at index
/// (z·(endRow − beginRow) + y − beginRow)·dimensions[0] + x.
std::vector<float> MeanReflectivityRows(const StormField& field, const GridSpecification& grid,
  int beginRow, int endRow, Time time, double floor = 0.0);

} // namespace nexrad::testing

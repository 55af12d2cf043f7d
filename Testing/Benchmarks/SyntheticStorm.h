// SPDX-License-Identifier: BSD-3-Clause
// The volume that BenchmarkMapper draws.
#pragma once

#include "vtkSmartPointer.h"

#include <array>

class vtkImageData;

namespace nexrad::benchmarks
{

/**
 * The synthetic storm day (Core's StormField, seed 1) over KEAX, KILX and KLSX at 18:10 UTC on the
 * default grid of a merge: dBZ at the voxels' centres, -33 where there is no echo, the clear-air
 * return included. The box is 64 units wide from west to east, its height stretched 8 times.
 * @param scalarType VTK_FLOAT for dBZ as they are; VTK_UNSIGNED_CHAR rounds them after adding 33,
 * as nexrad::testing::SetStormFunctions expects it.
 */
vtkSmartPointer<vtkImageData> MakeSyntheticStorm(
  const std::array<int, 3>& dimensions, int scalarType);

} // namespace nexrad::benchmarks

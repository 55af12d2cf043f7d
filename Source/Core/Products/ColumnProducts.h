// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "nexrad/Products/VoxelLines.h"

#include <vector>

namespace nexrad
{

/// One number of each column of a volume, computed from all of its voxels.
struct ColumnProduct
{
  int width = 0;             ///< columns to the east
  int height = 0;            ///< and to the north
  std::vector<float> values; ///< east fastest, then north; 0 where there is none
  /// Echo where there is a value; NoEcho where the column was scanned and has none; RangeFolded
  /// where no voxel of it was scanned and some are folded; else NotScanned.
  std::vector<VoxelState> states;
};

/// Formula P2: the height in m above mean sea level at which reflectivity falls below a threshold
/// in dBZ, sought from above: linear between the two levels about it where the upper one has an
/// echo too. Where the upper one has none, was not scanned or does not exist, the height of the
/// highest voxel that reaches the threshold, at its centre. Throws Error for another moment than
/// REF.
ColumnProduct MakeEchoTops(const VoxelLines& voxels, double threshold, const RangeLoop& loop = {});

/// Formula P3: the vertically integrated liquid in kg/m², 3.44e-6 Σ Z^(4/7) Δz with Z in mm⁶/m³,
/// reflectivities above 56 dBZ taken as 56 dBZ, because they are hail rather than rain. Voxels
/// without an echo add nothing. Throws Error for another moment than REF.
ColumnProduct MakeIntegratedLiquid(const VoxelLines& voxels, const RangeLoop& loop = {});

/// Formula P4: the density of the vertically integrated liquid in g/m³: the liquid of P3 through
/// the height of the echo top of P2 at a threshold in dBZ above the ground at the nearest radar
/// (VoxelLines::ground). Columns without an echo top above the ground have no value. Throws Error
/// for another moment than REF.
ColumnProduct MakeLiquidDensity(
  const VoxelLines& voxels, double threshold, const RangeLoop& loop = {});

} // namespace nexrad

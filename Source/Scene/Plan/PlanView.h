// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Scene/Plan/PlanOptions.h"
#include "Scene/Plan/PlanSource.h"

#include <cstddef>
#include <string>
#include <vector>

namespace nexrad::scene
{

/// One value of each column of a volume, as a map shows them.
struct PlanView
{
  int width = 0;             ///< columns to the east
  int height = 0;            ///< and to the north
  std::vector<float> values; ///< east fastest, then north; without meaning where nothing is known
  /// Of the moment: the voxel's. Of an ancillary array: Echo where there is a value, else that of
  /// the moment; NotScanned where column filling made the value without any radar.
  std::vector<VoxelState> states;
  std::string where; ///< which voxels these are, for a caption
};

/// Takes one voxel of each column, or computes the echo top in m, the liquid in kg/m² or its
/// density in g/m³. Of an
/// ancillary array (`plan.array`) its value in that voxel, so that the map of the array belongs to
/// the map of the moment with the same choice. Throws Error for an array that the volume does not
/// have, naming those it has, for a height outside it, for a composite of PHI or RHO, and for an
/// echo top or liquid of another moment than REF or of an array.
PlanView MakePlanView(
  const PlanSource& source, const PlanOptions& plan, const RangeLoop& loop = {});

} // namespace nexrad::scene

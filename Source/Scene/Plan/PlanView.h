// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Scene/Plan/PlanOptions.h"
#include "nexrad/Products/VoxelLines.h"

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

class vtkImageData;

namespace nexrad::scene
{

/// What a map is made of, where it is: a copy of a whole volume takes longer than its map.
struct PlanSource
{
  VoxelLines voxels; ///< of the moment
  /// AncillaryArrays of the moment, a value a voxel; nullptr: there is none.
  const float* age = nullptr;
  const std::uint8_t* radars = nullptr;
  const float* weight = nullptr;
  const std::uint8_t* nearestSite = nullptr;
  bool sharpened = false; ///< GriddedVolume::sharpened
};

/// Calls `visit(name, values)` for each ancillary array, as ForEachAncillaryArray does.
template <class Visit>
void ForEachAncillaryArray(const PlanSource& source, const Visit& visit)
{
  visit("age", source.age);
  visit("radars", source.radars);
  visit("weight", source.weight);
  visit("site", source.nearestSite);
}

/// That of a volume, which must outlive it.
PlanSource SourceOf(const GriddedVolume& volume);

/// That of a volume of values or of codes (vtkNexradImageConversion.h), which must outlive it.
/// Throws Error, naming the array, for a volume without the arrays of a moment.
PlanSource SourceOf(vtkImageData* volume);

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

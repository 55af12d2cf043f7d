// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "nexrad/Products/VoxelLines.h"

#include <cstdint>

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

} // namespace nexrad::scene

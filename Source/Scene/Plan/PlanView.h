// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "nexrad/Products/ColumnProducts.h"
#include "nexrad/Products/VoxelLines.h"

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

class vtkImageData;

namespace nexrad::scene
{

/// Which voxel of each column a map shows, or what is computed of all of them.
enum class PlanLevel
{
  Composite,    ///< that of the largest value; of VEL, of the largest speed
  Lowest,       ///< the lowest that was scanned
  Height,       ///< that at one height
  EchoTop,      ///< the height at which reflectivity falls below a threshold (P2)
  Liquid,       ///< the vertically integrated liquid of the reflectivity (P3)
  LiquidDensity ///< that through the height of the echo top (P4)
};

/// A map in place of the volume.
struct PlanOptions
{
  PlanLevel level = PlanLevel::Composite;
  double height = 0.0; ///< m above mean sea level, of PlanLevel::Height
  std::string array;   ///< which of the volume's arrays, as "REF_age"; empty: the moment. Products
                       ///< of whole columns have none
  double threshold = 18.0; ///< dBZ, of PlanLevel::EchoTop and LiquidDensity

  bool operator==(const PlanOptions& other) const
  {
    return level == other.level && height == other.height && array == other.array &&
           threshold == other.threshold;
  }
};

/// Whether a map is computed of the reflectivity of all voxels of a column; other maps show one
/// voxel of it.
constexpr bool IsColumnProduct(PlanLevel level)
{
  return level == PlanLevel::EchoTop || level == PlanLevel::Liquid ||
         level == PlanLevel::LiquidDensity;
}

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

/// That of a volume of values or of codes (vtkNexradImageConversion.h), which must outlive it.
/// Throws Error, naming the array, for a volume without the arrays of a moment.
PlanSource SourceOf(vtkImageData* volume);

/// One value of each column of a volume, as a map shows them; without meaning where nothing is
/// known. States of the moment are the voxel's; of an ancillary array Echo where there is a value,
/// else that of the moment, and NotScanned where column filling made the value without any radar.
struct PlanView : ColumnProduct
{
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

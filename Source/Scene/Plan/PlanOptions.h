// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

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

} // namespace nexrad::scene

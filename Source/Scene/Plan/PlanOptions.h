// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

namespace nexrad::scene
{

/// Which voxel of each column a map shows, or what is computed of all of them.
enum class PlanLevel
{
  Composite, ///< that of the largest value; of VEL, of the largest speed
  Lowest,    ///< the lowest that was scanned
  Height,    ///< that at one height
  EchoTop,   ///< the height at which reflectivity falls below a threshold (P2)
  Liquid     ///< the vertically integrated liquid of the reflectivity (P3)
};

/// A map in place of the volume.
struct PlanOptions
{
  PlanLevel level = PlanLevel::Composite;
  double height = 0.0; ///< m above mean sea level, of PlanLevel::Height
  std::string array;   ///< which of the volume's arrays, as "REF_age"; empty: the moment. EchoTop
                       ///< and Liquid have none
  double threshold = 18.0; ///< dBZ, of PlanLevel::EchoTop
};

} // namespace nexrad::scene

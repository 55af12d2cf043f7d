// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "nexrad/Model/RadarVolume.h"

#include <cstddef>
#include <vector>

namespace nexrad
{

/// The rays of a volume that tell about the gates of one sweep of reflectivity. The halves of a
/// split cut serve each other: the surveillance half has ρ_hv and Z_DR, the Doppler half velocity
/// and spectrum width.
struct SweepSources
{
  std::size_t sweep = 0;            ///< in the RadarVolume
  std::vector<const Ray*> own;      ///< of each ray of the sweep
  std::vector<const Ray*> velocity; ///< in its direction, with VEL; nullptr where there is none
  std::vector<const Ray*> twoWaves; ///< in its direction, with RHO; nullptr where there is none
};

/// The sources of the sweeps that MakePolarVolume makes of REF, in their order.
std::vector<SweepSources> FindSources(const RadarVolume& volume);

} // namespace nexrad

// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "nexrad/Beams/TiltGap.h"
#include "nexrad/Grid/GriddedVolume.h"

#include <cstddef>

namespace nexrad
{

/// Whether there is an echo of which nothing is known: it is folded, or quality control took it
/// out.
inline bool IsUnknown(VoxelState state)
{
  return state == VoxelState::RangeFolded || state == VoxelState::Filtered;
}

/// What one radar has at one place of one tilt at the time of the merge. `value` is without meaning
/// unless the state is Echo.
struct TiltSample
{
  VoxelState state = VoxelState::NotScanned;
  bool assumed = false; ///< no echo beyond the last gate, which nobody measured (Formulas G4)
  float value = 0.0F;
  float lowest =
    0.0F; ///< degrees, elevation of the nearest ray; of two observations, the lower one's
  float highest = 0.0F; ///< degrees, the higher one's
  float fade = 0.0F; ///< 0…1: how much the site counts, by the age of what it saw (Formulas A6)
  float age = 0.0F;  ///< s between the time of the merge and the nearer of the rays used
};

/// What the tilts of a radar have over a column about the gap above the tilt `lower`.
TiltGapValues ValuesAbout(const TiltSample* samples, std::size_t tilts, std::size_t lower);

} // namespace nexrad

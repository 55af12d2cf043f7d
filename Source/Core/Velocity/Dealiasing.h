// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "nexrad/System/RangeLoop.h"
#include "nexrad/Velocity/VelocityVolume.h"
#include "nexrad/Velocity/WindProfile.h"

namespace nexrad
{

/// What helps to find the folds of a volume.
struct DealiasOptions
{
  /// The wind over the radar, from a sounding or a model. Without levels: the profile is found in
  /// the volume itself (FindFoldedWind).
  WindProfile wind;
  /// The profile of the volume before; it serves at heights at which the volume has none.
  WindProfile before;
  RangeLoop loop; ///< over sweeps; empty: on this thread
};

/// How many gates were dealiased.
struct DealiasCounts
{
  std::size_t measured = 0; ///< gates with a velocity
  std::size_t unfolded = 0; ///< of them, those whose velocity was changed
  std::size_t unknown = 0;  ///< of them, those whose fold nothing tells
};

/// Unfolds the velocities of a volume (Formulas V1 to V4): v + 2·n·v_N, with n and the Nyquist
/// velocity v_N of each gate and ray. Gates whose n nothing decides become NotSampled. Rays without
/// a Nyquist velocity, as terminal radars send them, stay as they are.
///
/// Neighbouring gates with like velocities form regions; regions are merged along their borders,
/// the clearest first; what is connected is placed by the wind profile of all sweeps and by the
/// sweeps below and above.
DealiasCounts Dealias(VelocityVolume& volume, const DealiasOptions& options = {});

} // namespace nexrad

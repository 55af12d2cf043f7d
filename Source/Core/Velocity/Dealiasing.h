// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "nexrad/System/RangeLoop.h"
#include "nexrad/Velocity/FoldPlacement.h"
#include "nexrad/Velocity/VelocityVolume.h"
#include "nexrad/Velocity/WindProfile.h"

namespace nexrad
{

/// Finds the folds of the gates of a sweep that are of no region, or of one that was not placed:
/// those to which the gates about them are near, in several turns. A gate that agrees with none of
/// its neighbours stays without a fold.
void FillFolds(SweepFolds& sweep);

/// The folds of all gates of a sweep: those that it has, and those of gates without any neighbour
/// of known fold that are within half a Nyquist velocity of what the wind profile and the sweeps
/// below and above lead to expect. The others stay without a fold (Formulas V4).
std::vector<Fold> PlaceLoneGates(const SweepFolds& sweep, const ExpectedVelocities& expected);

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
/// velocity v_N of each gate and ray. Gates whose n nothing decides become Unknown. Rays without a
/// Nyquist velocity, as terminal radars send them, stay as they are.
///
/// Neighbouring gates with like velocities form regions; regions are merged along their borders,
/// the clearest first; what is connected is placed by the wind profile of all sweeps and by the
/// sweeps below and above.
DealiasCounts Dealias(VelocityVolume& volume, const DealiasOptions& options = {});

/// Pairs of neighbouring gates (in range, and in azimuth) of a volume, and those of them that
/// differ by more than the Nyquist velocity (Formulas V4). Rays without one are left out.
struct JumpCounts
{
  std::size_t pairs = 0;
  std::size_t jumps = 0;

  double Share() const { return pairs == 0 ? 0.0 : double(jumps) / double(pairs); }
};
JumpCounts CountJumps(const VelocityVolume& volume);

} // namespace nexrad

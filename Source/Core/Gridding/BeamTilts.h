// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "nexrad/Beams/BeamVolume.h"
#include "nexrad/Beams/TiltEdges.h"
#include "nexrad/Grid/GriddedVolume.h"

#include <cstddef>
#include <vector>

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

/// One observation of a tilt: a sweep; or, where a volume has no sweep at the tilt but sweeps below
/// and above it, these two, weighted by the angles.
struct TiltObservation
{
  const BeamSweep* lower = nullptr;
  const BeamSweep* upper = nullptr; ///< nullptr: `lower` alone
  float shareOfUpper = 0.0F;        ///< 0…1
  float lowerBegin = 0.0F;          ///< s from the time of the merge to the first ray of `lower`
  float upperBegin = 0.0F;          ///< the same of `upper`

  /// True when its rays leave no gap and all lie on one side of the time, after it or not: where it
  /// has a gate, no other observation on that side is needed.
  bool IsWhole(bool after) const;
  float Begin() const; ///< s from the time of the merge, of the earliest ray
  float End() const;   ///< of the latest ray
};

/// One elevation angle that a radar observed about a time, and the observations of it.
struct BeamTilt
{
  float elevation = 0.0F;              ///< degrees, mean over the sweeps
  float tangent = 0.0F;                ///< of the elevation
  std::vector<TiltObservation> before; ///< may hold rays at or before the time, the latest first:
                                       ///< they are used in this order
  std::vector<TiltObservation> after;  ///< may hold rays after the time, the earliest first
};

/// The tilts of some volumes of one radar (Formulas A5), ascending. Repeated cuts are several
/// observations of one tilt. When the pattern changes between the volumes, the tilts are those of
/// all patterns, and a volume without a sweep at a tilt is interpolated there from its sweeps below
/// and above, so that each tilt has observations before and after the time wherever the radar
/// scanned. For a volume whose sweep at the tilt lost stray rays, the same interpolation is added
/// after all other observations: it replaces the rays that were left out. Observations farther than
/// `gap` from the time are left out, and so are tilts without a sweep of their own. The volumes
/// must outlive the tilts.
std::vector<BeamTilt> FindTilts(
  const std::vector<const BeamVolume*>& volumes, Time time, Duration gap);

} // namespace nexrad

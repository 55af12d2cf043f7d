// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "nexrad/Velocity/VelocityVolume.h"

#include <cstddef>

namespace nexrad::testing
{

/// How many gates of a dealiased volume have the fold of the truth (Formulas V4).
struct FoldScore
{
  std::size_t right = 0;
  std::size_t wrong = 0;
  std::size_t unknown = 0;
  std::size_t largestPatch = 0; ///< gates of the largest connected patch of wrong gates
  /// Gates of known fold that differ from at most one of the eight about them by half a Nyquist
  /// velocity or more: wind, not noise.
  std::size_t smooth = 0;
  std::size_t smoothRight = 0;

  /// Percent of the gates whose fold is known.
  double RightShare() const;
  /// Percent of the smooth gates.
  double SmoothRightShare() const;
  /// Percent of the gates that were measured.
  double UnknownShare() const;
};

/// Compares gates that are valid in the truth. Velocities within 1 m/s have the same fold.
FoldScore CompareFolds(const VelocityVolume& truth, const VelocityVolume& result);

/// Pairs of neighbouring gates (in range, and in azimuth) of a volume, and those of them that
/// differ by more than the Nyquist velocity (Formulas V4). Rays without one are left out.
struct JumpCounts
{
  std::size_t pairs = 0;
  std::size_t jumps = 0;

  /// Percent of the pairs.
  double Share() const;
};
JumpCounts CountJumps(const VelocityVolume& volume);

} // namespace nexrad::testing

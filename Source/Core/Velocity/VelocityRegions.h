// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "nexrad/Velocity/RegionMerging.h"
#include "nexrad/Velocity/SweepRing.h"

#include <cstdint>
#include <vector>

namespace nexrad
{

/// Connected gates of a sweep that have one fold, and what their borders ask for (Formulas V2).
struct VelocityRegions
{
  static constexpr std::int32_t None = -1;
  std::vector<std::int32_t> label; ///< of each gate of the ring; None: of no region
  std::vector<std::uint32_t> size; ///< gates of each region
  /// Pairs of gates beside each other, and pairs across gaps of up to 20 gates or 10 rays. Pairs of
  /// rays of different Nyquist velocities are left out.
  std::vector<RegionBorder> borders;
};

/// Joins neighbours (in range, and in azimuth where the shear along the azimuth is not strong)
/// whose folded velocities differ by less than 0.3 of their Nyquist velocity. Gates that disagree
/// with half of their neighbours, and regions of a few gates, are of no region: they are noise that
/// could connect what has different folds, and are placed last.
VelocityRegions FindRegions(const SweepRing& ring);

} // namespace nexrad

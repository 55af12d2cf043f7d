// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "nexrad/Velocity/RegionMerging.h"
#include "nexrad/Velocity/VelocityVolume.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <vector>

namespace nexrad
{

/// Which gates are connected: each gate refers to an earlier one of its region, or to itself.
class ConnectedGates
{
public:
  explicit ConnectedGates(std::size_t count)
    : parent(count)
  {
    std::iota(parent.begin(), parent.end(), std::int32_t(0));
  }

  /// The first gate of the region of a gate.
  std::int32_t Find(std::int32_t gate)
  {
    while (parent[std::size_t(gate)] != gate)
    {
      std::int32_t& up = parent[std::size_t(gate)];
      up = parent[std::size_t(up)];
      gate = up;
    }
    return gate;
  }

  /// Makes the regions of two gates one.
  void Join(std::size_t a, std::size_t b)
  {
    const std::int32_t first = this->Find(std::int32_t(a));
    const std::int32_t second = this->Find(std::int32_t(b));
    parent[std::size_t(std::max(first, second))] = std::min(first, second);
  }

private:
  std::vector<std::int32_t> parent;
};

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

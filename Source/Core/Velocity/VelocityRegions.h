// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "nexrad/Velocity/VelocityVolume.h"

#include <algorithm>
#include <array>
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

/// For each fold from −MostFolds to MostFolds how much speaks for it.
struct FoldVotes
{
  std::array<float, 2 * MostFolds + 1> weights{};

  void Add(int fold, float weight)
  {
    if (fold >= -MostFolds && fold <= MostFolds)
    {
      weights[static_cast<std::size_t>(fold + MostFolds)] += weight;
    }
  }
  /// Makes the weight of a fold at least as large as `weight`.
  void Raise(int fold, float weight) { this->Add(fold, std::max(0.0F, weight - this->Of(fold))); }
  float Of(int fold) const
  {
    return fold >= -MostFolds && fold <= MostFolds
             ? weights[static_cast<std::size_t>(fold + MostFolds)]
             : 0.0F;
  }
  /// Adds other votes, those for fold n to fold n + shift.
  void AddShifted(const FoldVotes& other, int shift, float factor = 1.0F);
  int Best() const;
  float Total() const { return std::accumulate(weights.begin(), weights.end(), 0.0F); }
  /// How much more speaks for the best fold than for all others together.
  float Lead() const { return 2.0F * this->Of(this->Best()) - this->Total(); }
};

/// The same votes for the opposite difference.
FoldVotes Turned(const FoldVotes& votes);

/// What the pairs of gates along the border of two regions ask for: votes for fold(b) − fold(a).
struct RegionBorder
{
  std::int32_t a = 0;
  std::int32_t b = 0; ///< above a
  FoldVotes votes;
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

/// Regions that were merged: the fold of a region is that of its cluster and the region's offset.
struct RegionClusters
{
  std::vector<std::int32_t> cluster; ///< of each region
  std::vector<std::int8_t> offset;   ///< of each region: its fold less that of its cluster
  std::vector<std::uint32_t> size;   ///< gates of each cluster
  std::vector<RegionBorder> borders; ///< between clusters that were not merged
};

/// Merges regions along their borders, the one that is clearest over its length first (Formulas
/// V2). Two clusters stay apart when their border says little for their size.
RegionClusters MergeRegions(
  const std::vector<std::uint32_t>& sizes, const std::vector<RegionBorder>& borders);

} // namespace nexrad

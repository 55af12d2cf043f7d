// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "nexrad/Velocity/VelocityVolume.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace nexrad
{

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
  float Total() const;
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

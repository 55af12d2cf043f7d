// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "nexrad/System/RangeLoop.h"
#include "nexrad/Velocity/VelocityRegions.h"
#include "nexrad/Velocity/VelocityVolume.h"
#include "nexrad/Velocity/WindProfile.h"

#include <cstddef>
#include <vector>

namespace nexrad
{

/// A sweep while it is dealiased.
struct SweepFolds
{
  explicit SweepFolds(const VelocitySweep& sweep);

  SweepRing ring;
  VelocityRegions regions;
  RegionClusters clusters;
  std::vector<Fold> regionFold; ///< of each region; NoFold until it is known
  std::vector<Fold> gateFold;   ///< of each gate of the ring; NoFold where it is not known

  /// The unfolded velocity of a gate, m/s; NaN where its fold is not known.
  float Unfolded(std::size_t row, std::size_t gate) const;
};

/// What the radial velocity of each gate should be near to: of a wind profile, and of the nearest
/// gates of the sweeps below and above whose folds are known.
class ExpectedVelocities
{
public:
  /// `sweeps` and `wind` are not owned. `index` is that of the sweep.
  ExpectedVelocities(
    const std::vector<SweepFolds>& sweeps, std::size_t index, const WindProfile& wind);

  /// Adds what speaks for each fold of a gate. `withSweeps`: of other sweeps too. Returns the votes
  /// that there would be if the gate were as expected.
  float AddVotes(std::size_t row, std::size_t gate, bool withSweeps, FoldVotes& votes) const;

private:
  struct GateWind
  {
    float east;
    float north;
    float weight; // 0 where the profile has no wind
  };
  struct OtherSweep
  {
    const SweepFolds* sweep;
    std::vector<std::size_t> row;  // of each row: that of the other sweep, or SweepRing::NoRow
    std::vector<std::size_t> gate; // of each gate: that of the other sweep, or all of its gates
    std::vector<float> weight;     // of each gate: less where the other beam is farther away
  };

  void AddWind(const WindProfile& wind);
  void AddSweep(const SweepFolds& other);

  const SweepFolds& own;
  std::vector<GateWind> winds;
  std::vector<float> sine; // of the azimuth of each row
  std::vector<float> cosine;
  std::vector<OtherSweep> others;
};

/// Finds the folds of the clusters of regions of all sweeps: first of those that the wind profile
/// places clearly, then of those that clusters beside them and sweeps below and above place
/// (Formulas V3). Regions that disagree with their cluster after that get a fold of their own. A
/// volume without any wind profile begins with the fold that brings the mean of a sweep's largest
/// cluster nearest to 0.
void PlaceClusters(std::vector<SweepFolds>& sweeps, const WindProfile& wind, const RangeLoop& loop);

} // namespace nexrad

// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "nexrad/Beams/EchoLayers.h"
#include "nexrad/Beams/TiltEdges.h"
#include "nexrad/Grid/GridSpecification.h"
#include "nexrad/Grid/GriddedVolume.h"
#include "nexrad/Gridding/BeamSampling.h"

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace nexrad
{

/// The levels of a grid as one radar sees them.
struct SiteLevels
{
  /// `altitude` of the antenna, m above mean sea level; `effectiveRadius` of the beams' path, m;
  /// `overlapLength` is L of Formulas W4, m; 0 for equal weights.
  SiteLevels(
    const GridSpecification& grid, double altitude, double effectiveRadius, double overlapLength);

  /// Whether an elevation of this tangent surely passes above the highest level over a column.
  bool AreBelow(float tangent, float halfTangent) const
  {
    constexpr float margin = 1.0001F;
    const float t = halfTangent;
    return (tangent + t) * 2.0F * t / (1.0F + t * t) > margin * std::abs(ratio.back());
  }

  float radius = 0.0F;       ///< a_e, m
  float bottom = 0.0F;       ///< m above the antenna, of the lowest level
  float perMetre = 0.0F;     ///< levels in a metre
  std::vector<float> ratio;  ///< h/(a_e + h) of each level
  std::vector<float> weight; ///< exp(−(h/L)²) of each level; 1 without a length
};

/// What is made of a voxel that several radars scanned.
enum class OverlapStrategy
{
  Mean,    ///< all count alike (Formulas W1)
  Nearest, ///< the nearest radar alone (W2)
  Maximum, ///< the largest value, echo when one radar sees any (W3)
  Distance ///< by distance: exp(−(r/L)²) (W4)
};

/// One radar over one column.
struct SiteColumn
{
  int site = 0;             ///< its number in the merge
  float halfTangent = 0.0F; ///< ColumnDirection
  float weight = 1.0F;      ///< of the radar at the column's foot
  const SiteLevels* levels = nullptr;
  const std::vector<TiltEdges>* edges = nullptr;
  const TiltSample* samples = nullptr; ///< of each tilt
  /// What layers change in the gap above each tilt but the last (Formulas G12); nullptr: nothing.
  const EchoLayers::Changes* layers = nullptr;
};

/// Puts together what the radars saw over one column of voxels: first each radar between its tilts
/// (Formulas G2, G3, G6), reflectivity in dBZ by G8, G11 and G12 and other moments linearly in the
/// elevation angle; then the radars by a strategy (W1 to W8).
class BeamColumn
{
public:
  static constexpr std::uint8_t NoSite = AncillaryArrays::NoSite;

  /// `trend`: reflectivity in dBZ is interpolated between tilts by G11 and G12, else by G8 alone.
  BeamColumn(int levels, OverlapStrategy strategy, const ValueRule& rule, bool ancillary,
    bool trend = false);

  /// Forgets the column before.
  void Clear();

  /// Adds a radar. For Nearest, and for the nearest site among the ancillary arrays, the radars
  /// must be added in the order of their distances.
  void Add(const SiteColumn& site);

  /// The same of a radar of which the tilts from the first to before the end scanned the column,
  /// have no echo and count in full, or as much as no one asks, and the others did not scan it. Of
  /// these tilts the samples of the first and the last are looked at, of the last unless it passes
  /// above the levels. No layers, no ancillary arrays.
  void AddQuiet(const SiteColumn& site, std::size_t firstTilt, std::size_t endTilt);
  /// The levels from the first to before the second one that such a radar scanned; none: 0, 0.
  std::pair<int, int> QuietLevels(
    const SiteColumn& site, std::size_t firstTilt, std::size_t endTilt) const;

  /// Whether a radar found any voxel to be range folded or filtered.
  bool HasUnknown() const { return anyUnknown; }
  /// Whether a radar gave an echo to any voxel.
  bool HasEcho() const;
  /// Whether another column of as many levels was given the same by its radars.
  bool HasSameSums(const BeamColumn& other) const;

  /// Decides each voxel; then the results below hold.
  void Finish(float fill);

  /// Fills between and below what was scanned, as Formulas T7 does; after Finish.
  void FillColumn();

  const std::vector<float>& Values() const { return values; }
  const std::vector<VoxelState>& States() const { return states; }
  const std::vector<float>& Weights() const { return scanned; }
  const std::vector<float>& Ages() const { return ages; }
  const std::vector<std::uint8_t>& Radars() const { return radars; }
  const std::vector<std::uint8_t>& NearestSites() const { return nearestSites; }

private:
  struct Gap;
  void AddGap(const SiteColumn& site, const Gap& gap);
  void AddEdge(const SiteColumn& site, const Gap& gap);
  void AddTrend(const SiteColumn& site, const Gap& gap);
  void AccumulateTrend(const Gap& gap);
  void AccumulateNone(int from, int to);
  void AddNone(const SiteColumn& site, const Gap& gap, int from, int to);
  void AddEcho(const SiteColumn& site, const Gap& gap, int from, int to, float lower, float upper);
  void AccumulateEcho(int from, int to);
  void AddUnknown(VoxelState state, int from, int to);
  void AddState(const SiteColumn& site, const Gap& gap, const TiltSample& sample, int from, int to);
  void ConvertEchoes();
  void AddAncillary(const SiteColumn& site, const Gap& gap, int from, int to);
  void WeighLevels(const SiteColumn& site, const Gap& gap, int from, int to);
  void ShareLevels(const SiteColumn& site, const Gap& gap, int from, int to);

  const int levelCount;
  const OverlapStrategy strategy;
  const ValueRule rule;
  const bool ancillary;
  const bool trend;
  std::vector<float> scanned;      // sum of the weights of the radars that scanned the voxel
  std::vector<float> echo;         // of those that saw echo
  std::vector<float> sum;          // of weight × value; for Maximum, the largest value
  int echoFrom = 0;                // levels of echo lie from here
  int echoTo = 0;                  // to before here
  std::vector<VoxelState> unknown; // the state where no radar measured anything
  bool anyUnknown = false;
  std::vector<float> ages;
  std::vector<std::uint8_t> radars;
  std::vector<std::uint8_t> nearestSites;
  std::vector<float> weights; // of the radar that is being added
  std::vector<float> shares;  // of the upper tilt
  std::vector<float> values;
  std::vector<VoxelState> states;
};

} // namespace nexrad

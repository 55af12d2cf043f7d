// SPDX-License-Identifier: BSD-3-Clause
#include "nexrad/Velocity/FoldPlacement.h"

#include "nexrad/Geometry/Angles.h"
#include "nexrad/Geometry/Beam.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <numeric>
#include <utility>

namespace nexrad
{

namespace
{

constexpr double farthestTilt = 3.0; // degrees between sweeps that place each other
constexpr double depth = 1'000.0;    // m of height over which the wind changes
constexpr double windReach =
  4'000.0; // m above and below the profile that its ends still tell something
constexpr double reach = 80'000.0;     // m over which the profile's wind changes
constexpr float windWeight = 0.3F;     // of a gate of the profile, against one of another sweep
constexpr float borderWeight = 2.0F;   // of a pair of gates of two clusters
constexpr float leastTotal = 1.0F;     // votes that place a cluster
constexpr float leastShare = 0.7F;     // of the votes that place a cluster
constexpr float leastCloseness = 0.5F; // of the votes if a small cluster were as expected
constexpr int passes = 4;

// Votes for the fold that brings a velocity nearest to what is expected.
void AddVote(float velocity, float expected, float nyquist, float weight, FoldVotes& votes)
{
  const float turns = (expected - velocity) / (2.0F * nyquist);
  const float fold = std::nearbyint(turns);
  votes.Add(int(fold), weight * (1.0F - 2.0F * std::abs(turns - fold)));
}

// What speaks for each fold of a region or cluster, and how much would if it were as expected.
struct Evidence
{
  FoldVotes votes;
  float most = 0.0F;
};

std::vector<Evidence> EvidenceOfRegions(
  const SweepFolds& sweep, const ExpectedVelocities& expected, bool withSweeps)
{
  std::vector<Evidence> evidence(sweep.regions.size.size());
  for (std::size_t row = 0; row < sweep.ring.rows; ++row)
  {
    for (std::size_t gate = 0; gate < sweep.ring.gates; ++gate)
    {
      const std::int32_t label = sweep.regions.label[row * sweep.ring.gates + gate];
      if (label != VelocityRegions::None)
      {
        Evidence& own = evidence[std::size_t(label)];
        own.most += expected.AddVotes(row, gate, withSweeps, own.votes);
      }
    }
  }
  return evidence;
}

std::vector<Evidence> EvidenceOfClusters(
  const SweepFolds& sweep, const std::vector<Evidence>& ofRegions)
{
  std::vector<Evidence> evidence(sweep.clusters.size.size());
  for (std::size_t region = 0; region < ofRegions.size(); ++region)
  {
    Evidence& cluster = evidence[std::size_t(sweep.clusters.cluster[region])];
    cluster.votes.AddShifted(ofRegions[region].votes, -sweep.clusters.offset[region]);
    cluster.most += ofRegions[region].most;
  }
  return evidence;
}

// A small cluster far from what is expected is noise, which any fold would fit.
bool IsClear(const Evidence& evidence, std::uint32_t size)
{
  constexpr std::uint32_t small = 50; // gates
  const float total = evidence.votes.Total();
  const float best = evidence.votes.Of(evidence.votes.Best());
  return total >= leastTotal && best >= leastShare * total &&
         (size >= small || best >= leastCloseness * evidence.most);
}

// What regions or clusters beside those that have a fold ask for.
template <class AnyFold>
void AddBorders(const std::vector<RegionBorder>& borders, const std::vector<AnyFold>& folds,
  float weight, std::vector<Evidence>& evidence)
{
  for (const RegionBorder& border : borders)
  {
    const AnyFold a = folds[std::size_t(border.a)];
    const AnyFold b = folds[std::size_t(border.b)];
    if (a != NoFold)
    {
      evidence[std::size_t(border.b)].votes.AddShifted(border.votes, a, weight);
      evidence[std::size_t(border.b)].most += weight * border.votes.Total();
    }
    if (b != NoFold)
    {
      evidence[std::size_t(border.a)].votes.AddShifted(Turned(border.votes), b, weight);
      evidence[std::size_t(border.a)].most += weight * border.votes.Total();
    }
  }
}

// Other sweeps read the folds of gates, and those of regions only their own sweep: while several
// sweeps are placed at a time, only the latter may change.
void SetGateFolds(SweepFolds& sweep)
{
  for (std::size_t index = 0; index < sweep.gateFold.size(); ++index)
  {
    const std::int32_t label = sweep.regions.label[index];
    sweep.gateFold[index] =
      label == VelocityRegions::None ? NoFold : sweep.regionFold[std::size_t(label)];
  }
}

void SetClusterFolds(SweepFolds& sweep, const std::vector<int>& folds)
{
  for (std::size_t region = 0; region < sweep.regionFold.size(); ++region)
  {
    const int ofCluster = folds[std::size_t(sweep.clusters.cluster[region])];
    if (ofCluster != NoFold)
    {
      const int fold = ofCluster + sweep.clusters.offset[region];
      sweep.regionFold[region] = std::abs(fold) <= MostFolds ? Fold(fold) : NoFold;
    }
  }
}

// The fold that brings the mean velocity of the largest cluster nearest to 0.
void PlaceNearZero(SweepFolds& sweep)
{
  if (sweep.clusters.size.empty())
  {
    return;
  }
  const auto largest =
    std::int32_t(std::max_element(sweep.clusters.size.begin(), sweep.clusters.size.end()) -
                 sweep.clusters.size.begin());
  double turns = 0.0;
  for (std::size_t index = 0; index < sweep.ring.velocity.size(); ++index)
  {
    const std::int32_t label = sweep.regions.label[index];
    if (label != VelocityRegions::None && sweep.clusters.cluster[std::size_t(label)] == largest)
    {
      turns += double(sweep.ring.velocity[index]) /
                 (2.0 * double(sweep.ring.nyquist[index / sweep.ring.gates])) +
               double(sweep.clusters.offset[std::size_t(label)]);
    }
  }
  std::vector<int> folds(sweep.clusters.size.size(), NoFold);
  folds[std::size_t(largest)] =
    int(-std::lround(turns / double(sweep.clusters.size[std::size_t(largest)])));
  SetClusterFolds(sweep, folds);
}

// The fold that each cluster has now.
std::vector<int> FoldsOfClusters(const SweepFolds& sweep)
{
  std::vector<int> folds(sweep.clusters.size.size(), NoFold);
  for (std::size_t region = 0; region < sweep.regionFold.size(); ++region)
  {
    if (sweep.regionFold[region] != NoFold)
    {
      folds[std::size_t(sweep.clusters.cluster[region])] =
        sweep.regionFold[region] - sweep.clusters.offset[region];
    }
  }
  return folds;
}

void PlaceSweep(SweepFolds& sweep, const ExpectedVelocities& expected, bool withSweeps)
{
  std::vector<Evidence> evidence =
    EvidenceOfClusters(sweep, EvidenceOfRegions(sweep, expected, withSweeps));
  std::vector<int> folds = FoldsOfClusters(sweep);
  if (withSweeps)
  {
    AddBorders(sweep.clusters.borders, folds, borderWeight, evidence);
  }
  for (std::size_t cluster = 0; cluster < folds.size(); ++cluster)
  {
    if (IsClear(evidence[cluster], sweep.clusters.size[cluster]))
    {
      folds[cluster] = evidence[cluster].votes.Best();
    }
  }
  SetClusterFolds(sweep, folds);
}

// Gives regions the fold for which the regions beside them and the other sweeps together speak.
void CorrectRegions(SweepFolds& sweep, const ExpectedVelocities& expected)
{
  constexpr float sweepsWeight = 0.5F;
  constexpr float clear = 0.7F; // of all votes, to change a region
  std::vector<Evidence> evidence(sweep.regionFold.size());
  const std::vector<Evidence> own = EvidenceOfRegions(sweep, expected, true);
  for (std::size_t region = 0; region < evidence.size(); ++region)
  {
    evidence[region].votes.AddShifted(own[region].votes, 0, sweepsWeight);
  }
  AddBorders(sweep.regions.borders, sweep.regionFold, 1.0F, evidence);
  for (std::size_t region = 0; region < evidence.size(); ++region)
  {
    const FoldVotes& votes = evidence[region].votes;
    const float total = votes.Total();
    const int best = votes.Best();
    if (total >= leastTotal && votes.Of(best) >= clear * total)
    {
      sweep.regionFold[region] = Fold(best);
    }
  }
}

// Places the regions of some sweeps, and then their gates: what they read of each other does not
// depend on which of them is placed first, nor on the number of threads.
void PlaceAll(std::vector<SweepFolds>& sweeps, const std::vector<std::size_t>& which,
  const RangeLoop& loop, const std::function<void(std::size_t)>& place)
{
  RunEach(loop, which.size(), [&](std::size_t index) { place(which[index]); });
  RunEach(loop, which.size(), [&](std::size_t index) { SetGateFolds(sweeps[which[index]]); });
}

// Sweeps by elevation, in two halves of which none is next to another of its half: so most of what
// a sweep reads of others was placed just before.
std::array<std::vector<std::size_t>, 2> HalvesOf(const std::vector<SweepFolds>& sweeps)
{
  std::vector<std::size_t> order(sweeps.size());
  std::iota(order.begin(), order.end(), std::size_t(0));
  std::stable_sort(order.begin(), order.end(),
    [&](std::size_t a, std::size_t b)
    { return sweeps[a].ring.elevation < sweeps[b].ring.elevation; });
  std::array<std::vector<std::size_t>, 2> halves;
  for (std::size_t place = 0; place < order.size(); ++place)
  {
    halves[place % 2].push_back(order[place]);
  }
  return halves;
}

} // namespace

SweepFolds::SweepFolds(const VelocitySweep& sweep)
  : ring(MakeSweepRing(sweep))
  , regions(FindRegions(ring))
  , clusters(MergeRegions(regions.size, regions.borders))
  , regionFold(regions.size.size(), NoFold)
  , gateFold(ring.velocity.size(), NoFold)
{
}

float SweepFolds::Unfolded(std::size_t row, std::size_t gate) const
{
  const std::size_t index = row * ring.gates + gate;
  const Fold fold = gateFold[index];
  return fold == NoFold ? std::numeric_limits<float>::quiet_NaN()
                        : ring.velocity[index] + 2.0F * ring.nyquist[row] * float(fold);
}

ExpectedVelocities::ExpectedVelocities(
  const std::vector<SweepFolds>& sweeps, std::size_t index, const WindProfile& wind)
  : own(sweeps[index])
{
  for (const float azimuth : own.ring.azimuth)
  {
    sine.push_back(static_cast<float>(std::sin(double(azimuth) * RadiansPerDegree)));
    cosine.push_back(static_cast<float>(std::cos(double(azimuth) * RadiansPerDegree)));
  }
  this->AddWind(wind);
  // The nearest tilt below, the nearest above, and repetitions of the same.
  std::vector<std::pair<double, std::size_t>> nearest;
  for (std::size_t other = 0; other < sweeps.size(); ++other)
  {
    const double rise = sweeps[other].ring.elevation - own.ring.elevation;
    if (other != index && std::abs(rise) <= farthestTilt)
    {
      nearest.emplace_back(std::abs(rise), other);
    }
  }
  std::sort(nearest.begin(), nearest.end());
  constexpr std::size_t most = 4;
  for (std::size_t each = 0; each < std::min(most, nearest.size()); ++each)
  {
    this->AddSweep(sweeps[nearest[each].second]);
  }
}

void ExpectedVelocities::AddWind(const WindProfile& wind)
{
  const BeamModel beam;
  const double level = std::cos(own.ring.elevation * RadiansPerDegree);
  for (std::size_t gate = 0; gate < own.ring.gates; ++gate)
  {
    const double range = own.ring.RangeOf(gate);
    const double height = beam.Locate(range, own.ring.elevation).height;
    const std::optional<Wind> there = wind.At(height, windReach);
    const double away = wind.DistanceTo(height) / depth;
    const double weight =
      (0.2 + 0.8 * std::exp(-range * range / (reach * reach))) / (1.0 + away * away);
    winds.push_back(there ? GateWind{float(level * there->east), float(level * there->north),
                              windWeight * float(weight)}
                          : GateWind{0.0F, 0.0F, 0.0F});
  }
}

void ExpectedVelocities::AddSweep(const SweepFolds& other)
{
  const BeamModel beam;
  OtherSweep result{&other, {}, {}, {}};
  for (const float azimuth : own.ring.azimuth)
  {
    result.row.push_back(other.ring.RowAt(azimuth));
  }
  const double cosineRatio = std::cos(own.ring.elevation * RadiansPerDegree) /
                             std::cos(other.ring.elevation * RadiansPerDegree);
  for (std::size_t gate = 0; gate < own.ring.gates; ++gate)
  {
    const double range = own.ring.RangeOf(gate);
    const double place =
      std::nearbyint((range * cosineRatio - other.ring.firstGate) / other.ring.gateSpacing);
    const bool there = place >= 0.0 && place < static_cast<double>(other.ring.gates);
    const double apart = beam.Locate(range, own.ring.elevation).height -
                         beam.Locate(range * cosineRatio, other.ring.elevation).height;
    result.gate.push_back(there ? std::size_t(place) : other.ring.gates);
    result.weight.push_back(float(1.0 / (1.0 + apart * apart / (depth * depth))));
  }
  others.push_back(std::move(result));
}

float ExpectedVelocities::AddVotes(
  std::size_t row, std::size_t gate, bool withSweeps, FoldVotes& votes) const
{
  const float velocity = own.ring.velocity[row * own.ring.gates + gate];
  const float nyquist = own.ring.nyquist[row];
  const GateWind& wind = winds[gate];
  float most = wind.weight;
  if (wind.weight > 0.0F)
  {
    AddVote(
      velocity, wind.east * sine[row] + wind.north * cosine[row], nyquist, wind.weight, votes);
  }
  for (std::size_t each = 0; withSweeps && each < others.size(); ++each)
  {
    const OtherSweep& other = others[each];
    if (other.row[row] != SweepRing::NoRow && other.gate[gate] < other.sweep->ring.gates)
    {
      const float expected = other.sweep->Unfolded(other.row[row], other.gate[gate]);
      if (!std::isnan(expected))
      {
        AddVote(velocity, expected, nyquist, other.weight[gate], votes);
        most += other.weight[gate];
      }
    }
  }
  return most;
}

void PlaceClusters(std::vector<SweepFolds>& sweeps, const WindProfile& wind, const RangeLoop& loop)
{
  std::vector<std::size_t> all(sweeps.size());
  std::iota(all.begin(), all.end(), std::size_t(0));
  PlaceAll(sweeps, all, loop,
    [&](std::size_t index)
    {
      if (wind.levels.empty())
      {
        PlaceNearZero(sweeps[index]);
      }
      else
      {
        PlaceSweep(sweeps[index], ExpectedVelocities(sweeps, index, wind), false);
      }
    });
  const auto halves = HalvesOf(sweeps);
  for (int pass = 0; pass < passes; ++pass)
  {
    for (const std::vector<std::size_t>& half : halves)
    {
      PlaceAll(sweeps, half, loop,
        [&](std::size_t index)
        {
          const ExpectedVelocities expected(sweeps, index, wind);
          if (pass + 1 < passes)
          {
            PlaceSweep(sweeps[index], expected, true);
          }
          else
          {
            CorrectRegions(sweeps[index], expected);
          }
        });
    }
  }
}

} // namespace nexrad

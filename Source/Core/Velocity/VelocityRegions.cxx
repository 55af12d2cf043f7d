// SPDX-License-Identifier: BSD-3-Clause
#include "nexrad/Velocity/VelocityRegions.h"

#include "nexrad/Geometry/Angles.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <queue>
#include <unordered_map>
#include <utility>

namespace nexrad
{

namespace
{

constexpr float joinLimit = 0.3F;    // of the Nyquist velocity
constexpr float widestJoin = 5.0F;   // m/s: noise leads from one fold to the next in wider steps
constexpr float strongShear = 0.25F; // of the Nyquist velocity a ray
constexpr float tearingShear = 0.4F; // the same; neighbours in azimuth are not joined
constexpr float foldingShear = 0.6F; // the same, in the mean of the sizes of differences
constexpr std::uint32_t fewestGates = 4; // of a region
constexpr std::size_t widestGapGates = 20;
constexpr std::size_t widestGapRows = 10;

float JoinLimit(float nyquist)
{
  return std::min(widestJoin, joinLimit * nyquist);
}

enum Shear : std::uint8_t
{
  Weak,
  Strong,
  Tearing
};

// The shear along the azimuth between each row and the next: the mean difference over five gates,
// so that noise of single gates is no shear. Where the velocity jumps by nearly twice the Nyquist
// velocity, the jump itself folds to nothing; the pairs of rows on both sides show it.
class AzimuthShear
{
public:
  explicit AzimuthShear(const SweepRing& ring)
    : gates(ring.gates)
    , own(ring.rows * ring.gates, Weak)
    , widened(ring.rows * ring.gates, Weak)
  {
    for (std::size_t row = 0; row < ring.rows; ++row)
    {
      if (ring.beside[row] != 0 && ring.FoldAlike(row, ring.NextRow(row)))
      {
        this->SetRow(ring, row);
      }
    }
    for (std::size_t row = 0; row < ring.rows; ++row)
    {
      const std::uint8_t* before = &own[ring.PreviousRow(row) * gates];
      const std::uint8_t* here = &own[row * gates];
      const std::uint8_t* after = &own[ring.NextRow(row) * gates];
      for (std::size_t gate = 0; gate < gates; ++gate)
      {
        widened[row * gates + gate] = std::max({before[gate], here[gate], after[gate]});
      }
    }
  }

  // Between a gate of a row and that of the next row.
  std::uint8_t At(std::size_t index) const { return widened[index]; }

private:
  void SetRow(const SweepRing& ring, std::size_t row)
  {
    constexpr std::size_t reach = 2; // gates to both sides
    const float nyquist = ring.nyquist[row];
    const float* here = &ring.velocity[row * gates];
    const float* next = &ring.velocity[ring.NextRow(row) * gates];
    sums.assign(gates + 1, 0.0F);
    sizes.assign(gates + 1, 0.0F);
    counts.assign(gates + 1, 0);
    for (std::size_t gate = 0; gate < gates; ++gate)
    {
      const float difference = FoldDifference(next[gate] - here[gate], nyquist);
      const bool known = !std::isnan(difference);
      sums[gate + 1] = sums[gate] + (known ? difference : 0.0F);
      sizes[gate + 1] = sizes[gate] + (known ? std::abs(difference) : 0.0F);
      counts[gate + 1] = counts[gate] + (known ? 1 : 0);
    }
    for (std::size_t gate = 0; gate < gates; ++gate)
    {
      const std::size_t begin = gate < reach ? 0 : gate - reach;
      const std::size_t end = std::min(gate + reach + 1, gates);
      const float unit = nyquist * static_cast<float>(counts[end] - counts[begin]);
      const float size = sizes[end] - sizes[begin];
      // Differences near the Nyquist velocity fold to either sign, and their mean to nothing.
      const float sum = size > foldingShear * unit ? size : std::abs(sums[end] - sums[begin]);
      own[row * gates + gate] = sum > tearingShear * unit  ? Tearing
                                : sum > strongShear * unit ? Strong
                                                           : Weak;
    }
  }

  std::size_t gates;
  std::vector<std::uint8_t> own;
  std::vector<std::uint8_t> widened;
  std::vector<float> sums;  // of the differences, up to each gate
  std::vector<float> sizes; // of their sizes
  std::vector<int> counts;
};

// Gates that agree with at least half of their neighbours, and with two.
std::vector<std::uint8_t> FindSteadyGates(const SweepRing& ring)
{
  std::vector<std::uint8_t> steady(ring.velocity.size(), 0);
  for (std::size_t row = 0; row < ring.rows; ++row)
  {
    const std::size_t before = ring.PreviousRow(row);
    std::array<const float*, 3> rows = {nullptr, &ring.velocity[row * ring.gates], nullptr};
    rows[0] = ring.beside[before] != 0 ? &ring.velocity[before * ring.gates] : nullptr;
    rows[2] = ring.beside[row] != 0 ? &ring.velocity[ring.NextRow(row) * ring.gates] : nullptr;
    const float nyquist = ring.nyquist[row];
    const float limit = JoinLimit(nyquist);
    for (std::size_t gate = 0; gate < ring.gates; ++gate)
    {
      const float value = rows[1][gate];
      if (std::isnan(value))
      {
        continue;
      }
      int neighbours = -1; // the gate itself is counted below
      int agree = -1;
      const std::size_t begin = gate == 0 ? 0 : gate - 1;
      const std::size_t end = std::min(gate + 2, ring.gates);
      for (const float* line : rows)
      {
        for (std::size_t each = begin; line != nullptr && each < end; ++each)
        {
          const float difference = FoldDifference(line[each] - value, nyquist);
          neighbours += std::isnan(difference) ? 0 : 1;
          agree += std::abs(difference) < limit ? 1 : 0;
        }
      }
      steady[row * ring.gates + gate] = agree >= 2 && 2 * agree >= neighbours ? 1 : 0;
    }
  }
  return steady;
}

// How closely the gates of a sweep are joined: at level 0 those that differ by less than the limit,
// at each further level by half as much.
using JoinLevels = std::vector<std::uint8_t>;
constexpr std::uint8_t lastLevel = 2;

bool Joins(
  const SweepRing& ring, const JoinLevels& levels, float limit, std::size_t a, std::size_t b)
{
  const int level = std::max(levels[a], levels[b]);
  return std::abs(ring.velocity[a] - ring.velocity[b]) * static_cast<float>(1 << level) < limit;
}

void JoinRow(const SweepRing& ring, const std::vector<std::uint8_t>& steady,
  const AzimuthShear& shear, const JoinLevels& levels, std::size_t row, ConnectedGates& connected)
{
  const std::size_t here = row * ring.gates;
  const std::size_t next = ring.NextRow(row) * ring.gates;
  const float limit = JoinLimit(ring.nyquist[row]);
  const bool joinsNext = ring.beside[row] != 0 && ring.FoldAlike(row, ring.NextRow(row));
  for (std::size_t gate = 0; gate < ring.gates; ++gate)
  {
    if (steady[here + gate] == 0)
    {
      continue;
    }
    if (gate + 1 < ring.gates && steady[here + gate + 1] != 0 &&
        Joins(ring, levels, limit, here + gate, here + gate + 1))
    {
      connected.Join(here + gate, here + gate + 1);
    }
    if (joinsNext && steady[next + gate] != 0 && shear.At(here + gate) != Tearing &&
        Joins(ring, levels, limit, here + gate, next + gate))
    {
      connected.Join(here + gate, next + gate);
    }
  }
}

// Raises the level of the gates of regions that hold gates of different folds: along a ray, two
// gates beside each other differ by more than the Nyquist velocity. False when there is none.
bool RaiseLevels(const SweepRing& ring, const VelocityRegions& regions, JoinLevels& levels)
{
  constexpr int jumpsAllowed = 1;
  std::vector<int> jumps(regions.size.size(), 0);
  for (std::size_t index = 0; index + 1 < regions.label.size(); ++index)
  {
    const std::int32_t label = regions.label[index];
    if (label != VelocityRegions::None && label == regions.label[index + 1] &&
        (index + 1) % ring.gates != 0 &&
        std::abs(ring.velocity[index] - ring.velocity[index + 1]) >
          ring.nyquist[index / ring.gates])
    {
      ++jumps[std::size_t(label)];
    }
  }
  bool raised = false;
  for (std::size_t index = 0; index < regions.label.size(); ++index)
  {
    const std::int32_t label = regions.label[index];
    if (label != VelocityRegions::None && jumps[std::size_t(label)] > jumpsAllowed &&
        levels[index] < lastLevel)
    {
      ++levels[index];
      raised = true;
    }
  }
  return raised;
}

VelocityRegions NumberRegions(const std::vector<std::uint8_t>& steady, ConnectedGates& connected)
{
  VelocityRegions regions;
  std::vector<std::uint32_t> counts(steady.size(), 0);
  for (std::size_t gate = 0; gate < steady.size(); ++gate)
  {
    counts[std::size_t(connected.Find(std::int32_t(gate)))] += steady[gate];
  }
  regions.label.assign(steady.size(), VelocityRegions::None);
  for (std::size_t gate = 0; gate < steady.size(); ++gate)
  {
    const auto root = std::size_t(connected.Find(std::int32_t(gate)));
    if (steady[gate] == 0 || counts[root] < fewestGates)
    {
      continue;
    }
    if (root == gate)
    {
      regions.label[gate] = std::int32_t(regions.size.size());
      regions.size.push_back(counts[root]);
    }
    regions.label[gate] = regions.label[root]; // the root is the first gate of its region
  }
  return regions;
}

// Collects what pairs of gates ask for.
class BorderList
{
public:
  BorderList(const SweepRing& theRing, const VelocityRegions& theRegions)
    : ring(theRing)
    , regions(theRegions)
  {
  }

  // Gates of two regions in rows that fold alike.
  void Add(std::size_t first, std::size_t second, float nyquist, float weight)
  {
    std::int32_t a = regions.label[first];
    std::int32_t b = regions.label[second];
    const float difference = ring.velocity[first] - ring.velocity[second];
    const float rest = FoldDifference(difference, nyquist);
    int fold = difference == rest ? 0 : difference > 0.0F ? 1 : -1; // of the second less the first
    if (a > b)
    {
      std::swap(a, b);
      fold = -fold;
    }
    if (borders.empty() || borders.back().a != a || borders.back().b != b)
    {
      borders.push_back({a, b, {}});
    }
    constexpr float least = 0.1F; // the weight from 0.8 of the Nyquist velocity on
    const float quality = std::max(least, 1.0F - (1.0F - least) / 0.8F * std::abs(rest) / nyquist);
    borders.back().votes.Add(fold, weight * quality);
  }

  std::vector<RegionBorder> Take()
  {
    std::sort(borders.begin(), borders.end(),
      [](const RegionBorder& x, const RegionBorder& y)
      { return x.a != y.a ? x.a < y.a : x.b < y.b; });
    std::vector<RegionBorder> joined;
    for (const RegionBorder& border : borders)
    {
      if (joined.empty() || joined.back().a != border.a || joined.back().b != border.b)
      {
        joined.push_back(border);
      }
      else
      {
        joined.back().votes.AddShifted(border.votes, 0);
      }
    }
    return joined;
  }

private:
  const SweepRing& ring;
  const VelocityRegions& regions;
  std::vector<RegionBorder> borders;
};

void AddBordersInRange(const SweepRing& ring, const VelocityRegions& regions, BorderList& borders)
{
  constexpr float weight = 4.0F;
  for (std::size_t row = 0; row < ring.rows; ++row)
  {
    const std::size_t first = row * ring.gates;
    std::size_t last = ring.gates; // the gate of a region seen last; none at first
    for (std::size_t gate = 0; gate < ring.gates; ++gate)
    {
      const std::int32_t label = regions.label[first + gate];
      if (label == VelocityRegions::None)
      {
        continue;
      }
      if (last < gate && gate - last <= widestGapGates && regions.label[first + last] != label)
      {
        borders.Add(
          first + last, first + gate, ring.nyquist[row], weight / static_cast<float>(gate - last));
      }
      last = gate;
    }
  }
}

// Rays more than 1 km apart say less of each other: the wind changes with the distance.
std::vector<float> NearnessOfRows(const SweepRing& ring)
{
  constexpr double distance = 1'000.0; // m
  const double turn = 2.0 * Pi / static_cast<double>(std::max<std::size_t>(ring.rows, 1));
  std::vector<float> near;
  for (std::size_t gate = 0; gate < ring.gates; ++gate)
  {
    near.push_back(
      static_cast<float>(std::min(1.0, distance / std::max(distance, ring.RangeOf(gate) * turn))));
  }
  return near;
}

void AddBordersInAzimuth(const SweepRing& ring, const AzimuthShear& shear,
  const VelocityRegions& regions, BorderList& borders)
{
  constexpr float sheared = 0.1F;
  const std::vector<float> near = NearnessOfRows(ring);
  // For each gate how many rows ago one of a region was seen; 0: none.
  std::vector<std::size_t> ago(ring.gates, 0);
  for (std::size_t step = 0; step < ring.rows + widestGapRows; ++step)
  {
    const std::size_t row = step % ring.rows;
    const std::size_t before = ring.PreviousRow(row);
    const bool beside = ring.beside[before] != 0;
    for (std::size_t gate = 0; gate < ring.gates; ++gate)
    {
      const std::size_t index = row * ring.gates + gate;
      const std::int32_t label = regions.label[index];
      const std::size_t rows = ago[gate];
      if (label == VelocityRegions::None)
      {
        ago[gate] = beside && rows > 0 && rows < widestGapRows ? rows + 1 : 0;
        continue;
      }
      ago[gate] = 1;
      // Pairs that begin in the first turn, so that none counts twice.
      if (!beside || rows == 0 || step < rows || step - rows >= ring.rows || rows >= ring.rows)
      {
        continue;
      }
      const std::size_t other = (row + ring.rows - rows) % ring.rows;
      const std::size_t otherIndex = other * ring.gates + gate;
      if (regions.label[otherIndex] != label && ring.FoldAlike(row, other))
      {
        const bool strong = shear.At(otherIndex) != Weak;
        borders.Add(otherIndex, index, ring.nyquist[row],
          (strong ? sheared : 1.0F) * near[gate] / static_cast<float>(rows));
      }
    }
  }
}

// A border that waits to be merged. It is out of date when its clusters are no longer, or the lead
// of their border is another.
struct Candidate
{
  float lead;
  std::int32_t a;
  std::int32_t b;

  bool operator<(const Candidate& other) const
  {
    return lead != other.lead ? lead < other.lead
           : a != other.a     ? a > other.a
                              : b > other.b; // one order on all machines
  }
};

class Merger
{
public:
  Merger(const std::vector<std::uint32_t>& sizes, const std::vector<RegionBorder>& borders)
    : parent(sizes.size())
    , offset(sizes.size(), 0)
    , size(sizes)
    , neighbours(sizes.size())
  {
    std::iota(parent.begin(), parent.end(), std::int32_t(0));
    for (const RegionBorder& border : borders)
    {
      neighbours[std::size_t(border.a)].emplace(border.b, border.votes);
      neighbours[std::size_t(border.b)].emplace(border.a, Turned(border.votes));
      waiting.push({border.votes.Lead(), border.a, border.b});
    }
  }

  void Run()
  {
    while (!waiting.empty())
    {
      const Candidate next = waiting.top();
      waiting.pop();
      const auto& borders = neighbours[std::size_t(next.a)];
      const auto found = borders.find(next.b);
      if (found != borders.end() && found->second.Lead() == next.lead &&
          next.lead >= this->LeastLead(next.a, next.b))
      {
        const int fold = found->second.Best();
        borders.size() >= neighbours[std::size_t(next.b)].size()
          ? this->Merge(next.a, next.b, fold)
          : this->Merge(next.b, next.a, -fold);
      }
    }
  }

  RegionClusters Result()
  {
    RegionClusters result;
    std::vector<std::int32_t> number(parent.size(), -1);
    for (std::size_t region = 0; region < parent.size(); ++region)
    {
      int sum = 0;
      std::size_t root = region;
      for (; parent[root] != std::int32_t(root); root = std::size_t(parent[root]))
      {
        sum += offset[root];
      }
      if (number[root] < 0)
      {
        number[root] = std::int32_t(result.size.size());
        result.size.push_back(size[root]);
      }
      result.cluster.push_back(number[root]);
      result.offset.push_back(std::int8_t(std::clamp(sum, -100, 100)));
    }
    for (std::size_t root = 0; root < parent.size(); ++root)
    {
      for (const auto& [other, votes] : neighbours[root])
      {
        if (number[root] < number[std::size_t(other)])
        {
          result.borders.push_back({number[root], number[std::size_t(other)], votes});
        }
      }
    }
    return result;
  }

private:
  // A border along which two clusters are merged is no small part of the smaller one's edge.
  float LeastLead(std::int32_t a, std::int32_t b) const
  {
    const std::uint32_t smaller = std::min(size[std::size_t(a)], size[std::size_t(b)]);
    return std::max(1.0F, 0.3F * std::sqrt(static_cast<float>(smaller)));
  }

  // Puts cluster b into a; `fold` is fold(b) − fold(a).
  void Merge(std::int32_t a, std::int32_t b, int fold)
  {
    parent[std::size_t(b)] = a;
    offset[std::size_t(b)] = fold;
    size[std::size_t(a)] += size[std::size_t(b)];
    auto& into = neighbours[std::size_t(a)];
    into.erase(b);
    for (const auto& [other, votes] : neighbours[std::size_t(b)])
    {
      auto& back = neighbours[std::size_t(other)];
      back.erase(b);
      if (other == a)
      {
        continue;
      }
      FoldVotes& joined = into[other];
      joined.AddShifted(votes, fold);
      back[a] = Turned(joined);
      waiting.push({joined.Lead(), a, other});
    }
    neighbours[std::size_t(b)].clear();
    // Borders that were too short for the smaller cluster stay so: it only grew.
  }

  std::vector<std::int32_t> parent;
  std::vector<int> offset; // of each cluster that was merged: its fold less its parent's
  std::vector<std::uint32_t> size;
  std::vector<std::unordered_map<std::int32_t, FoldVotes>> neighbours;
  std::priority_queue<Candidate> waiting;
};

} // namespace

void FoldVotes::AddShifted(const FoldVotes& other, int shift, float factor)
{
  for (int fold = -MostFolds; fold <= MostFolds; ++fold)
  {
    this->Add(fold + shift, factor * other.Of(fold));
  }
}

int FoldVotes::Best() const
{
  return int(std::max_element(weights.begin(), weights.end()) - weights.begin()) - MostFolds;
}

FoldVotes Turned(const FoldVotes& votes)
{
  FoldVotes turned = votes;
  std::reverse(turned.weights.begin(), turned.weights.end());
  return turned;
}

VelocityRegions FindRegions(const SweepRing& ring)
{
  const std::vector<std::uint8_t> steady = FindSteadyGates(ring);
  const AzimuthShear shear(ring);
  JoinLevels levels(ring.velocity.size(), 0);
  VelocityRegions regions;
  do
  {
    ConnectedGates connected(ring.velocity.size());
    for (std::size_t row = 0; row < ring.rows; ++row)
    {
      JoinRow(ring, steady, shear, levels, row, connected);
    }
    regions = NumberRegions(steady, connected);
  } while (RaiseLevels(ring, regions, levels));
  BorderList borders(ring, regions);
  AddBordersInRange(ring, regions, borders);
  AddBordersInAzimuth(ring, shear, regions, borders);
  regions.borders = borders.Take();
  return regions;
}

RegionClusters MergeRegions(
  const std::vector<std::uint32_t>& sizes, const std::vector<RegionBorder>& borders)
{
  Merger merger(sizes, borders);
  merger.Run();
  return merger.Result();
}

} // namespace nexrad

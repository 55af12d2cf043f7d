// SPDX-License-Identifier: BSD-3-Clause
#include "nexrad/Velocity/RegionMerging.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <queue>
#include <unordered_map>
#include <utility>

namespace nexrad
{

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

float FoldVotes::Total() const
{
  return std::accumulate(weights.begin(), weights.end(), 0.0F);
}

FoldVotes Turned(const FoldVotes& votes)
{
  FoldVotes turned = votes;
  std::reverse(turned.weights.begin(), turned.weights.end());
  return turned;
}

namespace
{

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
      this->Consider(border.a, border.b, border.votes);
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

  void Consider(std::int32_t a, std::int32_t b, const FoldVotes& votes)
  {
    waiting.push({votes.Lead(), a, b});
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
      this->Consider(a, other, joined);
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

RegionClusters MergeRegions(
  const std::vector<std::uint32_t>& sizes, const std::vector<RegionBorder>& borders)
{
  Merger merger(sizes, borders);
  merger.Run();
  return merger.Result();
}

} // namespace nexrad

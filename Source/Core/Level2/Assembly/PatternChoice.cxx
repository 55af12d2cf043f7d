// SPDX-License-Identifier: BSD-3-Clause
#include "nexrad/Level2/Assembly/PatternChoice.h"

#include "nexrad/Model/Elevation.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

namespace nexrad
{

namespace
{

// The patterns of radars with message 1 (until 2008), before radars left out cuts or added some.
// Message 5 of later files, and the sweeps of the test data, have the same numbers.
const std::map<int, int> publishedCuts = {
  {11, 16}, {12, 17}, {21, 11}, {31, 8}, {32, 7}, {121, 20}, {211, 16}, {212, 17}, {221, 11}};

// The number that most rays have; of two alike that which came first.
std::optional<int> NumberOfMost(
  const std::vector<ArrivedSweep>& sweeps, std::size_t begin, std::size_t end)
{
  std::map<int, std::size_t> counts;
  std::optional<int> most;
  for (std::size_t i = begin; i < end; ++i)
  {
    for (const ArrivedRay* ray : sweeps[i].rays)
    {
      const int number = ray->coveragePatternNumber;
      if (number > 0 && (++counts[number] > counts[most.value_or(number)] || !most))
      {
        most = number;
      }
    }
  }
  return most;
}

double ElevationOf(const ArrivedSweep& sweep)
{
  std::vector<double> elevations;
  for (const ArrivedRay* ray : sweep.rays)
  {
    elevations.push_back(ray->ray.elevation);
  }
  return MedianOf(std::move(elevations));
}

// Sweeps that have the elevation of their cut in the pattern.
std::size_t CountFitting(const CoveragePattern& pattern, const std::vector<ArrivedSweep>& sweeps,
  std::size_t begin, std::size_t end)
{
  constexpr double sameCut = 0.5; // degrees
  return static_cast<std::size_t>(std::count_if(sweeps.begin() + static_cast<std::ptrdiff_t>(begin),
    sweeps.begin() + static_cast<std::ptrdiff_t>(end),
    [&pattern](const ArrivedSweep& sweep)
    {
      const std::size_t number = sweep.rays.front()->ray.elevationNumber;
      return number >= 1 && number <= pattern.cuts.size() &&
             std::abs(pattern.cuts[number - 1].elevation - ElevationOf(sweep)) < sameCut;
    }));
}

} // namespace

VolumeCuts ChoosePattern(const std::vector<ArrivedSweep>& sweeps, std::size_t begin,
  std::size_t end, const std::vector<CoveragePattern>& patterns)
{
  VolumeCuts cuts;
  cuts.patternNumber = NumberOfMost(sweeps, begin, end);
  std::vector<const CoveragePattern*> candidates;
  for (const CoveragePattern& pattern : patterns)
  {
    if (!cuts.patternNumber || pattern.number == *cuts.patternNumber)
    {
      candidates.push_back(&pattern);
    }
  }
  if (candidates.size() > 1)
  {
    std::vector<std::pair<std::size_t, const CoveragePattern*>> fitting;
    for (const CoveragePattern* pattern : candidates)
    {
      fitting.emplace_back(CountFitting(*pattern, sweeps, begin, end), pattern);
    }
    candidates = {std::max_element(fitting.begin(), fitting.end(),
      [](const auto& a, const auto& b) {
        return a.first < b.first;
      })->second};
  }
  if (!candidates.empty())
  {
    cuts.pattern = *candidates.front();
    cuts.expected = static_cast<int>(cuts.pattern->cuts.size());
  }
  else if (cuts.patternNumber && sweeps[begin].rays.front()->messageType == 1)
  {
    const auto published = publishedCuts.find(*cuts.patternNumber);
    cuts.expected =
      published != publishedCuts.end() ? std::optional(published->second) : std::nullopt;
  }
  return cuts;
}

std::vector<int> RepeatedCuts(const CoveragePattern& pattern)
{
  constexpr double sameElevation = 0.2; // degrees
  constexpr double lower = 0.3;         // degrees
  std::vector<int> repeated;
  double highest = -90.0; // of the cuts before
  for (auto cut = pattern.cuts.begin(); cut != pattern.cuts.end(); ++cut)
  {
    const bool wasScanned = std::any_of(pattern.cuts.begin(), cut,
      [cut](const CoverageCut& former)
      { return std::abs(former.elevation - cut->elevation) < sameElevation; });
    if (wasScanned && cut->elevation < highest - lower)
    {
      repeated.push_back(static_cast<int>(cut - pattern.cuts.begin()) + 1);
    }
    highest = std::max(highest, cut->elevation);
  }
  return repeated;
}

} // namespace nexrad

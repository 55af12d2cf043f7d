// SPDX-License-Identifier: BSD-3-Clause
#include "nexrad/Level2/Assembly/CutCheck.h"

#include "nexrad/Model/Elevation.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
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

namespace
{

constexpr double fullTurn = 360.0; // degrees

int NumberOf(const ArrivedSweep& sweep)
{
  return sweep.rays.front()->ray.elevationNumber;
}

std::vector<int> NumbersFrom(int first, int last)
{
  std::vector<int> numbers(static_cast<std::size_t>(std::max(0, last - first + 1)));
  std::iota(numbers.begin(), numbers.end(), first);
  return numbers;
}

void Append(const std::vector<int>& more, std::vector<int>& numbers)
{
  numbers.insert(numbers.end(), more.begin(), more.end());
}

// The sweeps of one volume of the file, and the ray behind them.
struct Cycle
{
  const ArrivedSweep& operator[](std::size_t index) const { return sweeps[begin + index]; }
  std::size_t Size() const { return end - begin; }
  const ArrivedSweep& Last() const { return sweeps[end - 1]; }
  const ArrivedRay* Next() const
  {
    return end < sweeps.size() ? sweeps[end].rays.front() : nullptr;
  }

  const std::vector<ArrivedSweep>& sweeps;
  std::size_t begin;
  std::size_t end;
};

// Checks one volume.
class CycleCheck
{
public:
  CycleCheck(const Cycle& theCycle, VolumeCuts& theCuts, const ArrivedDamage& theReport)
    : cycle(theCycle)
    , cuts(theCuts)
    , report(theReport)
  {
  }

  void Check()
  {
    cuts.begun = cycle[0].rays.front()->ray.radialStatus == RadialStatus::StartOfVolume;
    this->CheckNumbers();
    this->CheckSweepEnds();
    this->CheckEnd();
    this->FindRepeated();
  }

private:
  std::string OfAll() const
  {
    return cuts.expected ? " of " + std::to_string(*cuts.expected) : std::string();
  }

  // A volume with its end and fewer than half of its cuts: losses take some cuts, not most.
  bool IsExcerpt() const
  {
    int scanned = 0;
    int before = 0;
    for (std::size_t i = 0; i < cycle.Size(); ++i)
    {
      scanned += NumberOf(cycle[i]) != before ? 1 : 0;
      before = NumberOf(cycle[i]);
    }
    return 2 * scanned < before &&
           cycle.Last().rays.back()->ray.radialStatus == RadialStatus::EndOfVolume;
  }

  // Cuts that the numbers of the sweeps leave out.
  void CheckNumbers()
  {
    cuts.excerpt = this->IsExcerpt();
    int before = 0;
    for (std::size_t i = 0; i < cycle.Size(); ++i)
    {
      const int number = NumberOf(cycle[i]);
      const std::vector<int> lost = NumbersFrom(before + 1, number - 1);
      if (!lost.empty())
      {
        Append(lost, cuts.missing);
        this->ReportLost(lost, before, *cycle[i].rays.front());
      }
      before = number;
    }
    if (cuts.expected && before > *cuts.expected)
    {
      cuts.expected.reset(); // another pattern
      cuts.pattern.reset();
    }
  }

  void ReportLost(const std::vector<int>& lost, int before, const ArrivedRay& next) const
  {
    if (!cuts.excerpt)
    {
      const int number = next.ray.elevationNumber;
      report(next, this->Missing(lost) + ": " +
                     (before == 0 ? "the first elevation number is " + std::to_string(number)
                                  : "the elevation numbers go from " + std::to_string(before) +
                                      " to " + std::to_string(number)));
    }
  }

  std::string Missing(const std::vector<int>& lost) const
  {
    return CutsText(lost) + this->OfAll() + (lost.size() == 1 ? " is missing" : " are missing");
  }

  // The radar may break a cut off and scan it again; then nothing was lost.
  void CheckSweepEnds()
  {
    for (std::size_t i = 0; i + 1 < cycle.Size(); ++i)
    {
      if (cycle[i].cutOff && !cycle[i].restarted)
      {
        this->ReportEnd(i);
      }
    }
  }

  void ReportEnd(std::size_t index)
  {
    report(*cycle[index].rays.back(),
      "rays missing at the end of " + NameOfSweep(cycle.begin + index, cycle[index]));
  }

  void CheckEnd()
  {
    const ArrivedSweep& last = cycle.Last();
    const std::vector<int> rest =
      NumbersFrom(NumberOf(last) + 1, cuts.expected.value_or(NumberOf(last)));
    if (last.rays.back()->ray.radialStatus == RadialStatus::EndOfVolume)
    {
      cuts.end = rest.empty() ? VolumeEnd::LastCut : VolumeEnd::Early;
      cuts.notScanned = rest;
      return;
    }
    const Duration left = this->TimeLeft(rest.size());
    if (cycle.Next() != nullptr && this->IsBrokenOffBy(*cycle.Next(), left))
    {
      cuts.end = VolumeEnd::NewVolume;
      cuts.notScanned = rest;
      return;
    }
    Append(rest, cuts.missing);
    if (cycle.Next() == nullptr)
    {
      cuts.left = left;
      return; // VolumeAssembler says that the end is missing
    }
    if (!rest.empty())
    {
      report(*last.rays.back(), this->Missing(rest) + " before the next volume");
    }
    if (last.cutOff && !last.restarted)
    {
      this->ReportEnd(cycle.Size() - 1);
    }
  }

  bool IsBrokenOffBy(const ArrivedRay& next, Duration left) const
  {
    return IsBrokenOff(left, next.ray.time - cycle.Last().rays.back()->ray.time,
      next.ray.radialStatus == RadialStatus::StartOfVolume);
  }

  // What the rest of the volume takes, as fast as the last sweep; 0 where that tells no speed.
  Duration TimeLeft(std::size_t cutsLeft) const
  {
    const ArrivedSweep& last = cycle.Last();
    const double turned = std::abs(last.turned);
    const Duration taken = last.rays.back()->ray.time - last.rays.front()->ray.time;
    const double left =
      fullTurn * static_cast<double>(cutsLeft) + (last.cutOff ? fullTurn - turned : 0.0);
    return turned > 0.0 ? Duration(std::llround(left / turned * static_cast<double>(taken.count())))
                        : Duration();
  }

  void FindRepeated()
  {
    for (const int number : cuts.pattern ? RepeatedCuts(*cuts.pattern) : std::vector<int>())
    {
      for (std::size_t i = 0; i < cycle.Size(); ++i)
      {
        if (NumberOf(cycle[i]) == number)
        {
          cuts.repeated.push_back(number);
          break;
        }
      }
    }
  }

  const Cycle& cycle;
  VolumeCuts& cuts;
  const ArrivedDamage& report;
};

} // namespace

void CheckCuts(const std::vector<ArrivedSweep>& sweeps,
  const std::vector<CoveragePattern>& patterns, RadarVolume& volume, const ArrivedDamage& report)
{
  for (std::size_t begin = 0; begin < sweeps.size();)
  {
    std::size_t end = begin + 1;
    while (end < sweeps.size() && !BeginsCycle(volume.sweeps[end - 1], volume.sweeps[end]))
    {
      ++end;
    }
    const Cycle cycle{sweeps, begin, end};
    VolumeCuts& cuts = volume.cuts.emplace_back(ChoosePattern(sweeps, begin, end, patterns));
    CycleCheck(cycle, cuts, report).Check();
    begin = end;
  }
  volume.complete = !volume.cuts.empty() && volume.cuts.back().end != VolumeEnd::Missing &&
                    std::all_of(volume.cuts.begin(), volume.cuts.end(),
                      [](const VolumeCuts& cuts) { return cuts.missing.empty(); });
}

} // namespace nexrad

// SPDX-License-Identifier: BSD-3-Clause
#include "nexrad/Level2/Assembly/CutCheck.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <optional>
#include <string>

namespace nexrad
{

namespace
{

// The patterns of radars with message 1 (until 2008), before radars left out cuts or added some.
// Message 5 of later files, and the sweeps of the test data, have the same numbers.
const std::map<int, int> publishedCuts = {
  {11, 16}, {12, 17}, {21, 11}, {31, 8}, {32, 7}, {121, 20}, {211, 16}, {212, 17}, {221, 11}};

// The sweeps of one volume of the file, and the ray behind them.
struct Cycle
{
  const ArrivedSweep& operator[](std::size_t index) const { return sweeps[first + index]; }
  std::size_t Size() const { return behind - first; }
  auto begin() const { return sweeps.begin() + static_cast<std::ptrdiff_t>(first); }
  auto end() const { return sweeps.begin() + static_cast<std::ptrdiff_t>(behind); }
  const ArrivedSweep& Last() const { return sweeps[behind - 1]; }
  const ArrivedRay* Next() const
  {
    return behind < sweeps.size() ? sweeps[behind].rays.front() : nullptr;
  }

  const std::vector<ArrivedSweep>& sweeps;
  std::size_t first;
  std::size_t behind;
};

// The number that most rays have; of two alike that which came first.
std::optional<int> NumberOfMost(const Cycle& cycle)
{
  std::map<int, std::size_t> counts;
  std::optional<int> most;
  for (const ArrivedSweep& sweep : cycle)
  {
    for (const ArrivedRay* ray : sweep.rays)
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

// What is known of the coverage pattern of a volume. `sweeps` are those of the file.
VolumeCuts ChoosePattern(const Cycle& cycle, const std::vector<Sweep>& sweeps,
  const std::vector<CoveragePattern>& patterns)
{
  VolumeCuts cuts;
  cuts.patternNumber = NumberOfMost(cycle);
  std::ptrdiff_t most = -1; // sweeps that fit
  for (const CoveragePattern& pattern : patterns)
  {
    if (cuts.patternNumber && pattern.number != *cuts.patternNumber)
    {
      continue;
    }
    const auto begin = sweeps.begin();
    const std::ptrdiff_t fitting = std::count_if(begin + static_cast<std::ptrdiff_t>(cycle.first),
      begin + static_cast<std::ptrdiff_t>(cycle.behind),
      [&pattern](const Sweep& sweep) { return FindCut(pattern, sweep) != nullptr; });
    if (fitting > most)
    {
      most = fitting;
      cuts.pattern = pattern;
    }
  }
  if (cuts.pattern)
  {
    cuts.expected = static_cast<int>(cuts.pattern->cuts.size());
  }
  else if (cuts.patternNumber && cycle[0].rays.front()->messageType == 1)
  {
    const auto published = publishedCuts.find(*cuts.patternNumber);
    cuts.expected =
      published != publishedCuts.end() ? std::optional(published->second) : std::nullopt;
  }
  return cuts;
}

// The numbers of the cuts, from 1, at an elevation that the pattern had before a higher cut.
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
  // A volume with its end and fewer than half of its cuts: losses take some cuts, not most.
  bool IsExcerpt() const
  {
    int scanned = 0;
    int before = 0;
    for (const ArrivedSweep& sweep : cycle)
    {
      scanned += sweep.ElevationNumber() != before ? 1 : 0;
      before = sweep.ElevationNumber();
    }
    return 2 * scanned < before &&
           cycle.Last().rays.back()->ray.radialStatus == RadialStatus::EndOfVolume;
  }

  // Cuts that the numbers of the sweeps leave out.
  void CheckNumbers()
  {
    cuts.excerpt = this->IsExcerpt();
    int before = 0;
    for (const ArrivedSweep& sweep : cycle)
    {
      const int number = sweep.ElevationNumber();
      const std::vector<int> lost = NumbersFrom(before + 1, number - 1);
      if (!lost.empty())
      {
        Append(lost, cuts.missing);
        this->ReportLost(lost, before, *sweep.rays.front());
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
    return CutsText(lost) + (cuts.expected ? " of " + std::to_string(*cuts.expected) : "") +
           (lost.size() == 1 ? " is missing" : " are missing");
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
      "rays missing at the end of " + NameOfSweep(cycle.first + index, cycle[index]));
  }

  void CheckEnd()
  {
    const ArrivedSweep& last = cycle.Last();
    const std::vector<int> rest =
      NumbersFrom(last.ElevationNumber() + 1, cuts.expected.value_or(last.ElevationNumber()));
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
    constexpr double fullTurn = 360.0; // degrees
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
      if (std::any_of(cycle.begin(), cycle.end(),
            [number](const ArrivedSweep& sweep) { return sweep.ElevationNumber() == number; }))
      {
        cuts.repeated.push_back(number);
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
    VolumeCuts& cuts = volume.cuts.emplace_back(ChoosePattern(cycle, volume.sweeps, patterns));
    CycleCheck(cycle, cuts, report).Check();
    begin = end;
  }
  volume.complete = !volume.cuts.empty() && volume.cuts.back().end != VolumeEnd::Missing &&
                    std::all_of(volume.cuts.begin(), volume.cuts.end(),
                      [](const VolumeCuts& cuts) { return cuts.missing.empty(); });
}

} // namespace nexrad

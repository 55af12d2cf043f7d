// SPDX-License-Identifier: BSD-3-Clause
#include "nexrad/Quality/EchoClassification.h"

#include "nexrad/Model/Elevation.h"
#include "nexrad/Quality/BiologicalTest.h"
#include "nexrad/Quality/GroundTest.h"
#include "nexrad/Quality/SpikeTest.h"
#include "nexrad/Quality/SplitCuts.h"
#include "nexrad/Quality/SweepJudgement.h"
#include "nexrad/System/Error.h"
#include "nexrad/System/RangeLoop.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>

namespace nexrad
{

namespace
{

constexpr double verticalStep = 0.75;    // degrees between tilts that are compared
constexpr std::size_t rowsTogether = 30; // of one piece of work
constexpr double betweenGates = 2000.0;  // m, at most, between gates of two moments at one place

constexpr std::size_t fewGates = 3;         // fewer connected ones are speckle
constexpr std::size_t countedTogether = 64; // gates: their number fits in a byte

// Gates of a reason, of up to countedTogether ones. The compiler counts several at once.
std::size_t CountOf(const EchoReason* reasons, std::size_t gates, EchoReason reason)
{
  std::uint8_t count = 0;
  for (std::size_t gate = 0; gate < gates; ++gate)
  {
    count = static_cast<std::uint8_t>(count + (reasons[gate] == reason ? 1 : 0));
  }
  return count;
}

// Counts the gates of each reason. Most have none or are plain weather.
void CountReasons(const EchoReason* reasons, std::size_t count, ReasonCounts& counts)
{
  for (std::size_t begin = 0; begin < count; begin += countedTogether)
  {
    const EchoReason* first = reasons + begin;
    const std::size_t gates = std::min(countedTogether, count - begin);
    const std::size_t none = CountOf(first, gates, EchoReason::None);
    const std::size_t plain = CountOf(first, gates, EchoReason::Plain);
    if (none + plain == gates)
    {
      counts[static_cast<std::size_t>(EchoReason::None)] += none;
      counts[static_cast<std::size_t>(EchoReason::Plain)] += plain;
      continue;
    }
    for (std::size_t gate = 0; gate < gates; ++gate)
    {
      ++counts[static_cast<std::size_t>(first[gate])];
    }
  }
}

// Whether a gate is weather or biological echo. The compiler compares several at once.
bool Stays(EchoReason reason)
{
  const bool weather = (reason >= EchoReason::Plain) & (reason <= EchoReason::Debris);
  const bool biological =
    (reason >= EchoReason::FlightPolarimetry) & (reason <= EchoReason::ClearAir);
  return weather | biological;
}

// The speckle of a sweep (Formulas Q3): weather and biological echo of which fewer than three gates
// are connected.
void FindSpeckle(SweepJudgement& sweep)
{
  std::vector<std::uint8_t> members(sweep.reasons.size());
  std::transform(sweep.reasons.begin(), sweep.reasons.end(), members.begin(),
    [](EchoReason reason) -> std::uint8_t { return Stays(reason) ? 1 : 0; });
  const GateRegions regions(*sweep.grid, members);
  std::vector<std::size_t> gates(regions.Count(), 0);
  for (const GateRun& run : regions.Runs())
  {
    gates[run.region] += run.end - run.begin;
  }
  for (const GateRun& run : regions.Runs())
  {
    if (gates[run.region] < fewGates)
    {
      EchoReason* first = sweep.reasons.data() + sweep.grid->Index(run.place, 0);
      std::fill(first + run.begin, first + run.end, EchoReason::FewGates);
    }
  }
}

struct Rows
{
  std::size_t sweep;
  std::size_t begin;
  std::size_t end;
};

class Classifier
{
public:
  Classifier(const MeasuredMoments& theMoments, const RangeLoop& theLoop)
    : moments(theMoments)
    , loop(theLoop)
    , sources(FindSources(theMoments))
    , sweeps(theMoments.reflectivity.sweeps.size())
  {
  }

  EchoClassification Run()
  {
    RunEach(loop, sweeps.size(),
      [this](std::size_t number)
      { sweeps[number].Set(moments.reflectivity.sweeps[number], sources[number]); });
    for (SweepJudgement& sweep : sweeps)
    {
      sweep.above = this->FindAbove(sweep);
    }
    this->Judge();
    this->ForSweeps([this](std::size_t number) { this->FindClasses(sweeps[number]); });
    // Halves of split cuts copy from others, which must be done then.
    this->ForSweeps([this](std::size_t number) { this->FinishClasses(number, false); });
    this->ForSweeps([this](std::size_t number) { this->FinishClasses(number, true); });
    return this->Collect();
  }

private:
  // For the sweeps with gates.
  template <typename Work>
  void ForSweeps(const Work& work)
  {
    RunEach(loop, sweeps.size(),
      [&](std::size_t number)
      {
        if (sweeps[number].grid)
        {
          work(number);
        }
      });
  }

  // The lowest sweep that lies higher by so much that the difference of the tilts tells something.
  const EchoGrid* FindAbove(const SweepJudgement& own) const
  {
    const EchoGrid* found = nullptr;
    for (const SweepJudgement& other : sweeps)
    {
      const bool higher =
        own.grid && other.grid && other.grid->Elevation() > own.grid->Elevation() + verticalStep;
      found = higher && (!found || other.grid->Elevation() < found->Elevation()) ? other.grid.get()
                                                                                 : found;
    }
    return found;
  }

  // All gates of sweeps of two polarisations, some rows a piece of work, and those gates of the
  // others that can be ground.
  void Judge()
  {
    std::vector<Rows> pieces;
    for (std::size_t i = 0; i < sweeps.size(); ++i)
    {
      const std::size_t rows = sweeps[i].judged > 0 ? sweeps[i].grid->Rays() : 0;
      const std::size_t together = sweeps[i].IsPolarimetric() ? rowsTogether : rows;
      for (std::size_t row = 0; row < rows; row += together)
      {
        pieces.push_back({i, row, std::min(row + together, rows)});
      }
    }
    RunEach(loop, pieces.size(), [&](std::size_t piece) { this->JudgeRows(pieces[piece]); });
  }

  void JudgeRows(const Rows& rows)
  {
    SweepJudgement& sweep = sweeps[rows.sweep];
    if (!sweep.IsPolarimetric())
    {
      SearchGround(sweep, sources[rows.sweep]);
      return;
    }
    const std::vector<GateRange> wanted(sweep.grid->Rays(), GateRange{0, sweep.judged});
    RowJudge judge(sweep, sources[rows.sweep], wanted);
    for (std::size_t row = rows.begin; row < rows.end; ++row)
    {
      judge.Judge(row);
    }
  }

  void FindClasses(SweepJudgement& sweep)
  {
    if (sweep.judged > 0)
    {
      if (sweep.IsPolarimetric())
      {
        FindFlight(sweeps, sweep);
      }
      FindGround(sweep);
      FindPropagation(sweep);
      if (!sweep.IsPolarimetric())
      {
        FindClearAir(sweeps, sweep);
      }
    }
    FindSpikes(*sweep.grid, sweep.reasons);
  }

  // Of the sweeps that copy classes, or of the others.
  void FinishClasses(std::size_t number, bool copies)
  {
    const std::optional<std::size_t>& surveillance = sources[number].surveillance;
    if (surveillance.has_value() != copies)
    {
      return;
    }
    if (copies && sweeps[*surveillance].grid)
    {
      CopyClasses(sweeps[*surveillance], sweeps[number]);
    }
    FindSpeckle(sweeps[number]);
  }

  // Ground and biological echo of the gates of another half of a split cut.
  static void CopyClasses(const SweepJudgement& from, SweepJudgement& to)
  {
    const EchoGrid& grid = *to.grid;
    for (std::size_t place = 0; place < grid.Rays(); ++place)
    {
      const std::size_t other = from.grid->PlaceAt(grid.AzimuthAt(place));
      if (other == from.grid->Rays())
      {
        continue;
      }
      const float* row = grid.Row(place);
      EchoReason* own = to.reasons.data() + grid.Index(place, 0);
      const double step = grid.GateSpacing() / from.grid->GateSpacing();
      const double start =
        (grid.RangeOf(0) - from.grid->RangeOf(0)) / from.grid->GateSpacing() + 0.5;
      const GateRange held = grid.Held(place);
      for (std::size_t gate = held.begin; gate < held.end; ++gate)
      {
        const double at = start + step * static_cast<double>(gate);
        if (IsNumber(row[gate]) && at >= 0.0 && at < static_cast<double>(from.grid->Gates()) &&
            ClassOf(own[gate]) == EchoClass::Weather)
        {
          const EchoReason reason = from.ReasonAt(other, static_cast<std::size_t>(at));
          const EchoClass echoClass = ClassOf(reason);
          const bool flies =
            echoClass == EchoClass::Biological && row[gate] < StrongestBiologicalEcho;
          own[gate] = echoClass == EchoClass::Ground || flies ? reason : own[gate];
        }
      }
    }
  }

  EchoClassification Collect()
  {
    EchoClassification result;
    for (std::size_t number = 0; number < sweeps.size(); ++number)
    {
      const PolarSweep& sweep = moments.reflectivity.sweeps[number];
      const std::size_t rays = sweep.rays.size();
      SweepReasons reasons{sweep.gates, std::vector<GateRange>(rays),
        std::vector<std::size_t>(rays), std::move(sweeps[number].reasons)};
      std::size_t nothing = rays * sweep.gates; // gates that are not held
      const EchoGrid* grid = sweeps[number].grid.get();
      for (std::size_t place = 0; grid != nullptr && place < grid->Rays(); ++place)
      {
        const GateRange held = grid->Held(place);
        reasons.held[grid->RayAt(place)] = held;
        reasons.starts[grid->RayAt(place)] = grid->Index(place, 0);
        const EchoReason* first = reasons.reasons.data() + grid->Index(place, held.begin);
        CountReasons(first, held.Size(), result.counts);
        nothing -= held.Size();
      }
      result.counts[static_cast<std::size_t>(EchoReason::None)] += nothing;
      result.sweeps.push_back(std::move(reasons));
    }
    return result;
  }

  const MeasuredMoments& moments;
  const RangeLoop& loop;
  std::vector<SweepSources> sources;
  std::vector<SweepJudgement> sweeps;
};

} // namespace

EchoClassification ClassifyEcho(
  const PolarVolume& reflectivity, const MeasuredVolume& measured, const RangeLoop& loop)
{
  const auto judged = [](double elevation)
  { return JudgedRange(elevation - SameTilt) + betweenGates; };
  const RangeLoop own = loop ? loop : ThreadLoop(CoreCount());
  const MeasuredMoments moments(reflectivity, measured, judged, own);
  return Classifier(moments, own).Run();
}

EchoClassification ClassifyEcho(const RadarVolume& volume, const RangeLoop& loop)
{
  return ClassifyEcho(
    MakePolarVolume(volume, MomentName::REF),
    [&volume](MomentName moment, const WantedRange& wanted)
    { return MakePolarVolume(volume, moment, wanted); },
    loop);
}

bool RemovesClass(QualityLevel level, EchoClass echoClass)
{
  switch (echoClass)
  {
  case EchoClass::None:
  case EchoClass::Weather:
    return false;
  case EchoClass::Biological:
    return level == QualityLevel::Strict;
  default:
    return level != QualityLevel::Off;
  }
}

EchoGates GatesLeft(const ReasonCounts& counts, QualityLevel level)
{
  EchoGates left;
  for (std::size_t reason = 0; reason < EchoReasonCount; ++reason)
  {
    const EchoClass echoClass = ClassOf(static_cast<EchoReason>(reason));
    const bool stays = echoClass != EchoClass::None && !RemovesClass(level, echoClass);
    left.all += stays ? counts[reason] : 0;
    left.biological += stays && echoClass == EchoClass::Biological ? counts[reason] : 0;
  }
  return left;
}

ReasonCounts TakeOut(
  PolarVolume& reflectivity, const EchoClassification& classification, QualityLevel level)
{
  if (classification.sweeps.size() != reflectivity.sweeps.size())
  {
    throw Error("echo classes of " + std::to_string(classification.sweeps.size()) +
                " sweeps for a volume of " + std::to_string(reflectivity.sweeps.size()));
  }
  std::array<bool, EchoReasonCount> removes{};
  for (std::size_t reason = 0; reason < EchoReasonCount; ++reason)
  {
    removes[reason] = RemovesClass(level, ClassOf(static_cast<EchoReason>(reason)));
  }
  ReasonCounts counts{};
  for (std::size_t i = 0; i < reflectivity.sweeps.size(); ++i)
  {
    PolarSweep& sweep = reflectivity.sweeps[i];
    const SweepReasons& found = classification.sweeps[i];
    if (found.held.size() != sweep.rays.size() || found.gates != sweep.gates)
    {
      throw Error("echo classes of " + std::to_string(found.held.size() * found.gates) +
                  " gates for a sweep of " + std::to_string(sweep.rays.size() * sweep.gates));
    }
    const auto removed = [&removes](EchoReason reason)
    { return removes[static_cast<std::size_t>(reason)]; };
    std::vector<std::uint16_t> codes(sweep.gates);
    for (std::size_t ray = 0; ray < sweep.rays.size(); ++ray)
    {
      const EchoReason* own = found.reasons.data() + found.starts[ray];
      const GateRange held = found.held[ray];
      if (std::none_of(own + held.begin, own + held.end, removed))
      {
        continue;
      }
      sweep.Read(ray, codes.data());
      for (std::size_t gate = held.begin; gate < held.end; ++gate)
      {
        if (codes[gate] >= GateCode::FirstValue && removed(own[gate]))
        {
          codes[gate] = GateCode::Filtered;
          ++counts[static_cast<std::size_t>(own[gate])];
        }
      }
      sweep.rows.Replace(ray, codes.data());
    }
  }
  return counts;
}

} // namespace nexrad

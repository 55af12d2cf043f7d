// SPDX-License-Identifier: BSD-3-Clause
#include "nexrad/Quality/EchoClassification.h"

#include "nexrad/Model/Elevation.h"
#include "nexrad/Quality/EchoGrid.h"
#include "nexrad/Quality/EchoInterest.h"
#include "nexrad/Quality/GateEvidence.h"
#include "nexrad/Quality/GateRegions.h"
#include "nexrad/Quality/SpikeTest.h"
#include "nexrad/Quality/SplitCuts.h"
#include "nexrad/System/Error.h"
#include "nexrad/System/ThreadGroup.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <string>

namespace nexrad
{

namespace
{

constexpr double earthRadius = 4.0 / 3.0 * 6'371'000.0; // m, effective
constexpr double lowGround = 1000.0;                    // m, of the beam's lower edge
constexpr double trappedGround = 2500.0;                // m, the same
constexpr double highestGround = 5000.0;                // m, the same
constexpr double halfBeam = 0.5;                        // degrees
constexpr double surelyNear = 20'000.0;                 // m, where side lobes see the ground
constexpr double verticalStep = 0.75;                   // degrees between tilts that are compared
constexpr std::size_t rowsTogether = 30;
constexpr std::size_t fewGates = 3;
constexpr float seedInterest = 0.62F;
constexpr float highSeedInterest = 0.70F; // of gates as high as highestGround
constexpr float growth = 0.15F;           // less interest is enough for grown gates

constexpr std::uint8_t stillSpeed = 1 + 8 * 1; // 1 m/s, as SweepWork::speeds
constexpr std::uint8_t slowSpeed = 1 + 8 * 4;  // 4 m/s, as SweepWork::speeds

enum Mark : std::uint8_t
{
  Nothing,
  Grown,
  Seed
};

// One sweep in work. Arrays are rays × gates, in the order of the rays of the sweep.
struct SweepWork
{
  std::unique_ptr<EchoGrid> grid;
  const EchoGrid* above = nullptr;
  std::size_t judged = 0;     // gates of each ray that can be ground
  std::vector<float> heights; // m, of the lower edge of the beam, for each of these gates
  std::vector<float> limits;  // interest of a seed, for each of these gates
  std::vector<std::uint8_t> marks;
  std::vector<std::uint8_t> speeds;   // |V| in 0.125 m/s and 1 more; 0 unknown
  std::vector<std::int8_t> gradients; // dB a degree
  std::vector<EchoReason> reasons;
};

struct Task
{
  std::size_t sweep;
  std::size_t begin; // rows
  std::size_t end;
};

double HeightAt(double range, double elevation)
{
  return range * std::sin(elevation * 0.0174532925) + range * range / (2.0 * earthRadius);
}

std::size_t GatesNearGround(const EchoGrid& grid)
{
  std::size_t gates = grid.GatesWithin(surelyNear);
  while (gates < grid.Gates() &&
         HeightAt(grid.RangeOf(gates), grid.Elevation() - halfBeam) <= highestGround)
  {
    ++gates;
  }
  return gates;
}

// Heights of the beam's lower edge and the interest of seeds, for the gates that are judged.
void SetHeights(SweepWork& work)
{
  const EchoGrid& grid = *work.grid;
  for (std::size_t gate = 0; gate < work.judged; ++gate)
  {
    const double range = grid.RangeOf(gate);
    const auto height = static_cast<float>(HeightAt(range, grid.Elevation() - halfBeam));
    const float part =
      range < surelyNear ? 0.0F : Ramp(height, lowGround, static_cast<float>(highestGround));
    work.heights.push_back(height);
    work.limits.push_back(seedInterest + part * (highSeedInterest - seedInterest));
  }
}

bool IsUsable(const PolarSweep& sweep)
{
  return !sweep.rays.empty() && sweep.gates > 0 && sweep.gateSpacing > 0.0;
}

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
    this->MakeGrids();
    this->Judge();
    RunLoop(loop, static_cast<int>(sweeps.size()),
      [this](int begin, int end)
      {
        for (int i = begin; i < end; ++i)
        {
          this->Decide(static_cast<std::size_t>(i));
        }
      });
    RunLoop(loop, static_cast<int>(sweeps.size()),
      [this](int begin, int end)
      {
        for (int i = begin; i < end; ++i)
        {
          this->Finish(static_cast<std::size_t>(i));
        }
      });
    return this->Collect();
  }

private:
  void MakeGrids()
  {
    for (std::size_t i = 0; i < sweeps.size(); ++i)
    {
      const PolarSweep& sweep = moments.reflectivity.sweeps[i];
      if (IsUsable(sweep))
      {
        SweepWork& work = sweeps[i];
        work.grid = std::make_unique<EchoGrid>(sweep, loop);
        work.judged = sources[i].surveillance ? 0 : GatesNearGround(*work.grid);
        SetHeights(work);
        work.marks.assign(work.grid->Rays() * work.grid->Gates(), Nothing);
        work.speeds.assign(work.marks.size(), 0);
        work.gradients.assign(work.marks.size(), 0);
        work.reasons.assign(work.grid->Rays() * work.grid->Gates(), EchoReason::None);
      }
    }
    for (SweepWork& work : sweeps)
    {
      work.above = this->FindAbove(work);
    }
  }

  // The lowest sweep that lies higher by so much that the difference of the tilts tells something.
  const EchoGrid* FindAbove(const SweepWork& own) const
  {
    const EchoGrid* found = nullptr;
    for (const SweepWork& other : sweeps)
    {
      const bool higher =
        own.grid && other.grid && other.grid->Elevation() > own.grid->Elevation() + verticalStep;
      found = higher && (!found || other.grid->Elevation() < found->Elevation()) ? other.grid.get()
                                                                                 : found;
    }
    return found;
  }

  void Judge()
  {
    std::vector<Task> tasks;
    for (std::size_t i = 0; i < sweeps.size(); ++i)
    {
      const std::size_t rows = sweeps[i].judged > 0 ? sweeps[i].grid->Rays() : 0;
      for (std::size_t row = 0; row < rows; row += rowsTogether)
      {
        tasks.push_back({i, row, std::min(row + rowsTogether, rows)});
      }
    }
    RunLoop(loop, static_cast<int>(tasks.size()),
      [&](int begin, int end)
      {
        for (int i = begin; i < end; ++i)
        {
          this->JudgeRows(tasks[static_cast<std::size_t>(i)]);
        }
      });
  }

  void JudgeRows(const Task& task)
  {
    SweepWork& work = sweeps[task.sweep];
    EvidenceReader reader(*work.grid, work.above, sources[task.sweep], work.judged);
    std::vector<GateEvidence> evidence;
    for (std::size_t place = task.begin; place < task.end; ++place)
    {
      reader.Read(place, evidence);
      const float* row = work.grid->Row(place);
      const std::size_t first = work.grid->RayAt(place) * work.grid->Gates();
      const std::size_t end = std::min(work.judged, work.grid->Held(place).end);
      for (std::size_t gate = 0; gate < end; ++gate)
      {
        if (IsNumber(row[gate]))
        {
          const EchoInterest interest = InterestOf(evidence[gate]);
          const float limit = work.limits[gate];
          work.marks[first + gate] = interest.ground >= limit            ? Seed
                                     : interest.ground >= limit - growth ? Grown
                                                                         : Nothing;
          const float speed = evidence[gate].ownSpeed;
          work.speeds[first + gate] =
            IsNumber(speed) ? static_cast<std::uint8_t>(std::min(8.0F * speed, 254.0F) + 1.0F) : 0;
          work.gradients[first + gate] =
            static_cast<std::int8_t>(std::clamp(evidence[gate].gradient, -100.0F, 100.0F));
          work.reasons[first + gate] = interest.flight >= 0.6F && row[gate] < 35.0F
                                         ? EchoReason::FlightPolarimetry
                                         : EchoReason::None;
        }
      }
    }
  }

  void Decide(std::size_t number)
  {
    SweepWork& work = sweeps[number];
    if (!work.grid)
    {
      return;
    }
    const EchoGrid& grid = *work.grid;
    for (std::size_t place = 0; place < grid.Rays(); ++place)
    {
      const float* row = grid.Row(place);
      EchoReason* own = work.reasons.data() + grid.RayAt(place) * grid.Gates();
      const GateRange held = grid.Held(place);
      for (std::size_t gate = held.begin; gate < held.end; ++gate)
      {
        if (IsNumber(row[gate]) && own[gate] == EchoReason::None)
        {
          own[gate] = row[gate] >= 45.0F ? EchoReason::StrongCore : EchoReason::Plain;
        }
      }
    }
    if (work.judged > 0)
    {
      this->Grow(sources[number].correlation.sweep != nullptr, work);
    }
    FindSpikes(grid, work.reasons);
  }

  struct Region
  {
    std::size_t gates = 0;
    std::size_t seeds = 0;
    double gradients = 0.0;
    double heights = 0.0;   // m, of the beam's lower edge
    std::size_t border = 0; // gates beside it with a velocity
    std::size_t slow = 0;   // those that move slowly
  };

  // Ground: regions of likely gates that hold enough gates that are surely ground.
  void Grow(bool polarimetric, SweepWork& work)
  {
    const EchoGrid& grid = *work.grid;
    const GateRegions regions(grid, work.marks);
    std::vector<Region> all(regions.Count());
    for (const GateRun& run : regions.Runs())
    {
      Region& region = all[run.region];
      const std::size_t first = grid.RayAt(run.place) * grid.Gates();
      for (std::size_t gate = run.begin; gate < run.end; ++gate)
      {
        ++region.gates;
        region.seeds += work.marks[first + gate] == Seed ? 1 : 0;
        region.gradients += work.gradients[first + gate];
        region.heights += work.heights[gate];
      }
      this->AddBorder(work, run, region);
    }
    for (const GateRun& run : regions.Runs())
    {
      if (!IsGround(all[run.region]))
      {
        continue;
      }
      const std::size_t first = grid.RayAt(run.place) * grid.Gates();
      for (std::size_t gate = run.begin; gate < run.end; ++gate)
      {
        work.reasons[first + gate] = work.marks[first + gate] != Seed ? EchoReason::GroundRegion
                                     : polarimetric ? EchoReason::GroundPolarimetry
                                                    : EchoReason::GroundTexture;
      }
    }
  }

  static bool IsGround(const Region& region)
  {
    if (4 * region.seeds < region.gates)
    {
      return false;
    }
    const auto gates = static_cast<double>(region.gates);
    if (region.gradients > 8.0 * gates && region.heights < trappedGround * gates)
    {
      return true; // gone in the tilt above, and so low that the air can bend the beam to it
    }
    // Beside weather that moves across the beam, other weather moves slowly.
    return region.border < 4 || 2 * region.slow < region.border;
  }

  void AddBorder(const SweepWork& work, const GateRun& run, Region& region) const
  {
    const EchoGrid& grid = *work.grid;
    const auto add = [&](std::size_t place, std::size_t gate)
    {
      if (place >= grid.Rays() || gate >= grid.Gates())
      {
        return;
      }
      const std::size_t index = grid.RayAt(place) * grid.Gates() + gate;
      const std::uint8_t speed = work.speeds[index];
      if (speed >= stillSpeed && work.marks[index] == Nothing)
      {
        ++region.border;
        region.slow += speed < slowSpeed ? 1 : 0;
      }
    };
    add(run.place, run.begin - std::size_t(2));
    add(run.place, run.end + std::size_t(1));
    for (const int step : {-1, 1})
    {
      const std::size_t beside = grid.Beside(run.place, step);
      add(beside, run.begin);
      add(beside, (run.begin + run.end) / 2);
      add(beside, run.end - std::size_t(1));
    }
  }

  void Finish(std::size_t number)
  {
    SweepWork& work = sweeps[number];
    if (!work.grid)
    {
      return;
    }
    if (sources[number].surveillance && sweeps[*sources[number].surveillance].grid)
    {
      this->CopyClasses(sweeps[*sources[number].surveillance], work);
    }
    this->FindSpeckle(work);
  }

  void CopyClasses(const SweepWork& from, SweepWork& to) const
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
      const EchoReason* source = from.reasons.data() + from.grid->RayAt(other) * from.grid->Gates();
      EchoReason* own = to.reasons.data() + grid.RayAt(place) * grid.Gates();
      const double step = grid.GateSpacing() / from.grid->GateSpacing();
      const double start =
        (grid.RangeOf(0) - from.grid->RangeOf(0)) / from.grid->GateSpacing() + 0.5;
      const std::size_t end = grid.Held(place).end;
      for (std::size_t gate = 0; gate < end; ++gate)
      {
        const double at = start + step * static_cast<double>(gate);
        if (IsNumber(row[gate]) && at >= 0.0 && at < static_cast<double>(from.grid->Gates()) &&
            ClassOf(own[gate]) == EchoClass::Weather)
        {
          const EchoReason reason = source[static_cast<std::size_t>(at)];
          const EchoClass echoClass = ClassOf(reason);
          own[gate] = echoClass == EchoClass::Ground || echoClass == EchoClass::Biological
                        ? reason
                        : own[gate];
        }
      }
    }
  }

  void FindSpeckle(SweepWork& work) const
  {
    const EchoGrid& grid = *work.grid;
    std::array<std::uint8_t, EchoReasonCount> stays{};
    for (std::size_t reason = 0; reason < EchoReasonCount; ++reason)
    {
      const EchoClass echoClass = ClassOf(static_cast<EchoReason>(reason));
      stays[reason] = echoClass == EchoClass::Weather || echoClass == EchoClass::Biological;
    }
    std::vector<std::uint8_t> members(work.reasons.size());
    std::transform(work.reasons.begin(), work.reasons.end(), members.begin(),
      [&stays](EchoReason reason) { return stays[static_cast<std::size_t>(reason)]; });
    const GateRegions regions(grid, members);
    std::vector<std::size_t> gates(regions.Count(), 0);
    for (const GateRun& run : regions.Runs())
    {
      gates[run.region] += run.end - run.begin;
    }
    for (const GateRun& run : regions.Runs())
    {
      if (gates[run.region] < fewGates)
      {
        const auto first =
          work.reasons.begin() + static_cast<std::ptrdiff_t>(grid.RayAt(run.place) * grid.Gates());
        std::fill(first + run.begin, first + run.end, EchoReason::FewGates);
      }
    }
  }

  EchoClassification Collect()
  {
    EchoClassification result;
    for (std::size_t i = 0; i < sweeps.size(); ++i)
    {
      const PolarSweep& sweep = moments.reflectivity.sweeps[i];
      result.sweeps.push_back(std::move(sweeps[i].reasons));
      result.sweeps.back().resize(sweep.rays.size() * sweep.gates, EchoReason::None);
      for (const EchoReason reason : result.sweeps.back())
      {
        ++result.counts[static_cast<std::size_t>(reason)];
      }
    }
    return result;
  }

  const MeasuredMoments& moments;
  const RangeLoop& loop;
  std::vector<SweepSources> sources;
  std::vector<SweepWork> sweeps;
};

} // namespace

EchoClassification ClassifyEcho(
  const std::function<PolarVolume(MomentName)>& measured, const RangeLoop& loop)
{
  const MeasuredMoments moments(measured);
  const RangeLoop own = loop ? loop : ThreadLoop(CoreCount());
  return Classifier(moments, own).Run();
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
    const std::vector<EchoReason>& reasons = classification.sweeps[i];
    if (reasons.size() != sweep.rays.size() * sweep.gates)
    {
      throw Error("echo classes of " + std::to_string(reasons.size()) + " gates for a sweep of " +
                  std::to_string(sweep.rays.size() * sweep.gates));
    }
    const auto removed = [&removes](EchoReason reason)
    { return removes[static_cast<std::size_t>(reason)]; };
    if (std::none_of(reasons.begin(), reasons.end(), removed))
    {
      continue;
    }
    GateRows rows(sweep.rows.LargestCode());
    std::vector<std::uint16_t> codes(sweep.gates);
    for (std::size_t ray = 0; ray < sweep.rays.size(); ++ray)
    {
      sweep.Read(ray, codes.data());
      for (std::size_t gate = 0; gate < sweep.gates; ++gate)
      {
        const EchoReason reason = reasons[ray * sweep.gates + gate];
        if (codes[gate] >= GateCode::FirstValue && removed(reason))
        {
          codes[gate] = GateCode::Filtered;
          ++counts[static_cast<std::size_t>(reason)];
        }
      }
      rows.Append(codes.data(), codes.size());
    }
    rows.Finish();
    sweep.rows = std::move(rows);
  }
  return counts;
}

} // namespace nexrad

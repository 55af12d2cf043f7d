// SPDX-License-Identifier: BSD-3-Clause
#include "nexrad/Quality/GroundTest.h"

#include "nexrad/Quality/EchoGrid.h"
#include "nexrad/Quality/Textures.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace nexrad
{

namespace
{

constexpr std::size_t besideRuns = 2; // gates before and behind a run that FindGround looks at
constexpr int firstReach = 2;         // rays beyond one whose gates are missing

class GroundSearcher
{
public:
  GroundSearcher(SweepJudgement& theSweep, const SweepSources& theSources)
    : sweep(theSweep)
    , grid(*theSweep.grid)
    , sources(theSources)
    , wanted(grid.Rays())
    , changed(grid.Rays(), 0)
  {
  }

  void Run()
  {
    this->WantStillGates();
    for (int reach = firstReach; this->JudgeChanged(); reach *= 2)
    {
      this->WantRaysAboutGround(reach);
    }
  }

private:
  void WantStillGates()
  {
    const RowGeometry geometry = {sweep.judged, grid.RangeOf(0), grid.GateSpacing()};
    std::vector<std::uint16_t> codes;
    for (std::size_t place = 0; place < grid.Rays(); ++place)
    {
      const GateRange still = StillGates(
        grid.Row(place), grid.Held(place), sources.velocity, grid.RayAt(place), geometry, codes);
      const GateRange all = sweep.Judged(place);
      // Where most gates are asked for, the others may soon be, too.
      wanted[place] = 2 * still.Size() > all.Size() ? all : still;
      changed[place] = still.IsEmpty() ? 0 : 1;
    }
  }

  // False when no row has changed.
  bool JudgeChanged()
  {
    RowJudge judge(sweep, sources, wanted);
    bool any = false;
    for (std::size_t place = 0; place < grid.Rays(); ++place)
    {
      if (changed[place] != 0)
      {
        judge.Judge(place);
        changed[place] = 0;
        any = true;
      }
    }
    return any;
  }

  // Wants the rays through and beside regions with sure ground whose gates have not been judged,
  // and as many more to either side as reach.
  void WantRaysAboutGround(int reach)
  {
    if (std::find(sweep.signs.begin(), sweep.signs.end(), GroundSign::Sure) == sweep.signs.end())
    {
      return;
    }
    const GateRegions regions(grid, sweep.signs);
    std::vector<std::uint8_t> isSure(regions.Count(), 0);
    for (const GateRun& run : regions.Runs())
    {
      const std::uint8_t* signs = sweep.signs.data() + grid.Index(run.place, 0);
      const std::uint8_t* end = signs + run.end;
      isSure[run.region] |= std::find(signs + run.begin, end, GroundSign::Sure) != end ? 1 : 0;
    }
    for (const GateRun& run : regions.Runs())
    {
      if (isSure[run.region] != 0)
      {
        this->WantRaysAbout(run, reach);
      }
    }
  }

  void WantRaysAbout(const GateRun& run, int reach)
  {
    const GateRange about = {
      run.begin - std::min<std::size_t>(besideRuns, run.begin), run.end + besideRuns};
    for (const int step : {-1, 0, 1})
    {
      const std::size_t beside = grid.Beside(run.place, step);
      if (beside < grid.Rays() && this->Lacks(beside, about))
      {
        for (int each = -reach; each <= reach; ++each)
        {
          this->WantAllOf(grid.Beside(run.place, each));
        }
        return;
      }
    }
  }

  bool Lacks(std::size_t place, const GateRange& range) const
  {
    const GateRange needed = Common(range, sweep.Judged(place));
    return !needed.IsEmpty() &&
           (needed.begin < wanted[place].begin || needed.end > wanted[place].end);
  }

  void WantAllOf(std::size_t place)
  {
    if (place < grid.Rays() && this->Lacks(place, sweep.Judged(place)))
    {
      wanted[place] = sweep.Judged(place);
      changed[place] = 1;
    }
  }

  SweepJudgement& sweep;
  const EchoGrid& grid;
  const SweepSources& sources;
  std::vector<GateRange> wanted;     // of each row the gates that are judged
  std::vector<std::uint8_t> changed; // rows that are to be judged, again or at all
};

constexpr std::size_t fewestSure = 4; // one in so many gates of a region must be sure
constexpr double vanishing = 8.0;     // dB a degree, mean
constexpr double trapped = 2500.0; // m, mean of the lower beam edge: the air may bend it to earth
constexpr std::size_t fewestBeside = 4;        // gates beside a region that tell something
constexpr std::uint8_t still = SpeedCode(1.0); // m/s: below, they may be ground themselves
constexpr std::uint8_t slow = SpeedCode(4.0);  // m/s
constexpr std::int8_t surelyGone = 15;         // dB a degree

struct GroundRegion
{
  std::size_t gates = 0;
  std::size_t sure = 0;
  double gradients = 0.0; // sum, dB a degree
  double heights = 0.0;   // sum, m
  std::size_t beside = 0; // gates beside it that move
  std::size_t slow = 0;   // those that move slowly
};

void AddBeside(
  const SweepJudgement& sweep, std::size_t place, std::size_t gate, GroundRegion& region)
{
  if (!sweep.Judged(place).Holds(gate))
  {
    return;
  }
  const std::size_t index = sweep.grid->Index(place, gate);
  if (sweep.speeds[index] >= still && sweep.signs[index] == GroundSign::None)
  {
    ++region.beside;
    region.slow += sweep.speeds[index] < slow ? 1 : 0;
  }
}

void AddRun(const SweepJudgement& sweep, const GateRun& run, GroundRegion& region)
{
  for (std::size_t gate = run.begin; gate < run.end; ++gate)
  {
    const std::size_t index = sweep.grid->Index(run.place, gate);
    ++region.gates;
    region.sure += sweep.signs[index] == GroundSign::Sure ? 1 : 0;
    region.gradients += sweep.gradients[index];
    region.heights += static_cast<double>(sweep.heights[gate]);
  }
  // The second gate before and behind: the first may be partly of the region.
  AddBeside(sweep, run.place, run.begin - std::size_t(2), region);
  AddBeside(sweep, run.place, run.end + std::size_t(1), region);
  for (const int step : {-1, 1})
  {
    const std::size_t beside = sweep.grid->Beside(run.place, step);
    AddBeside(sweep, beside, run.begin, region);
    AddBeside(sweep, beside, (run.begin + run.end) / 2, region);
    AddBeside(sweep, beside, run.end - std::size_t(1), region);
  }
}

bool IsGround(const GroundRegion& region)
{
  if (fewestSure * region.sure < region.gates)
  {
    return false;
  }
  const auto gates = static_cast<double>(region.gates);
  if (region.gradients > vanishing * gates && region.heights < trapped * gates)
  {
    return true;
  }
  return region.beside < fewestBeside || 2 * region.slow < region.beside;
}

EchoReason ReasonOf(const SweepJudgement& sweep, std::size_t index)
{
  if (sweep.signs[index] == GroundSign::Sure)
  {
    return sweep.IsPolarimetric() ? EchoReason::GroundPolarimetry : EchoReason::GroundTexture;
  }
  return sweep.speeds[index] == 0 && sweep.gradients[index] >= surelyGone
           ? EchoReason::GroundHeight
           : EchoReason::GroundRegion;
}

constexpr double highestTilt = 1.0; // degrees: above, the air hardly bends a beam to earth
constexpr float weakestEcho = 5.0F; // dBZ of the gates of a region
constexpr double about = 1000.0;    // m along the ray: the tilt above has echo near to a gate
constexpr std::size_t widestGapAlongRay = 3; // km along the ray, within a region
constexpr float steepest = 0.012F;           // dB a metre of height by which weather becomes weaker
constexpr float poorest = -4.0F;             // dBZ at 50 km that the poorest of 38 real files has
constexpr float overNoise = 5.0F;            // dB over the weakest echo of the sweep
constexpr double fewestTelling = 20.0;       // gates of 1 km × 1° that the tilt above would see
constexpr double leastTelling = 0.03;        // the same, of all gates of a region

// What a region is like, at least, and how much of its outline is beside echo that the tilt above
// has, at most. Roughness is the mean squared difference over 1 km along the ray, dB².
constexpr float strongEcho = 30.0F; // dBZ, stronger than most shallow rain and snow
constexpr double leastStrong = 0.05;
constexpr double leastRoughness = 20.0;
constexpr double mostEdge = 0.15;
constexpr double surelyRough = 45.0; // no gate need be strong in an area as large
constexpr double largeArea = 100.0;  // gates of 1 km × 1°
constexpr double surelyStrong = 0.1; // side lobes of the tilt above see ground so strong and rough
constexpr double mostSureEdge = 0.3;

struct PropagationRegion
{
  std::size_t gates = 0;
  std::size_t telling = 0;
  std::size_t strong = 0;
  std::size_t outline = 0; // gates beside one that is not of the region
  std::size_t edge = 0;    // of these, gates beside weather that the tilt above has
  std::size_t doubted = 0; // gates that two polarisations do not call weather
  std::size_t pairs = 0;
  double squares = 0.0; // dB²
};

// What a gate is.
enum Mark : std::uint8_t
{
  Nothing, // no echo, or weak echo
  Alone,   // echo that the tilt above does not have
  Confirmed
};

class PropagationSearcher
{
public:
  explicit PropagationSearcher(SweepJudgement& theSweep)
    : sweep(theSweep)
    , grid(*theSweep.grid)
    , above(*theSweep.above)
    , step(
        std::max<std::size_t>(1, static_cast<std::size_t>(std::lround(about / grid.GateSpacing()))))
    , marks(grid.Rays() * theSweep.judged, Nothing)
  {
  }

  void Run()
  {
    this->SetGates();
    std::size_t telling = 0;
    for (std::size_t place = 0; place < grid.Rays(); ++place)
    {
      telling += this->MarkRow(place);
    }
    if (this->AreaOf(telling) >= fewestTelling)
    {
      this->JudgeRegions();
    }
  }

private:
  // Of each gate the reflectivity from which on weather is seen in the tilt above, and the gates of
  // that tilt that are near.
  void SetGates()
  {
    const auto last = static_cast<std::ptrdiff_t>(above.Gates());
    const auto gateOf = [&](double range)
    { return static_cast<std::size_t>(std::clamp<std::ptrdiff_t>(above.GateAt(range), 0, last)); };
    for (std::size_t gate = 0; gate < sweep.judged; ++gate)
    {
      const double range = std::max(1000.0, grid.RangeOf(gate));
      const double rise =
        BeamHeight(range, above.Elevation()) - BeamHeight(range, grid.Elevation());
      const float weakest = std::min(
        sweep.weakest[gate], poorest + static_cast<float>(20.0 * std::log10(range / 50e3)));
      needed.push_back(weakest + overNoise + steepest * static_cast<float>(rise));
      near.push_back({gateOf(range - about), std::min(above.Gates(), gateOf(range + about) + 1)});
    }
  }

  // Returns how many gates are alone and would be seen in the tilt above.
  std::size_t MarkRow(std::size_t place)
  {
    const std::size_t beyond = above.PlaceAt(grid.AzimuthAt(place));
    if (beyond == above.Rays())
    {
      return 0;
    }
    const std::array<std::size_t, 3> upper = {
      beyond, above.Beside(beyond, -1), above.Beside(beyond, 1)};
    const float* row = grid.Row(place);
    const std::size_t first = this->MarkIndex(place, 0);
    const GateRange judged = sweep.Judged(place);
    std::size_t telling = 0;
    for (std::size_t gate = judged.begin; gate < judged.end; ++gate)
    {
      const EchoClass known = ClassOf(sweep.reasons[grid.Index(place, gate)]);
      const bool isMeant = known == EchoClass::Weather || known == EchoClass::Ground;
      if (isMeant && row[gate] >= weakestEcho)
      {
        const Mark mark = this->MarkOf(upper, gate);
        marks[first + gate] = mark;
        telling += mark == Alone && row[gate] >= needed[gate] ? 1 : 0;
      }
    }
    return telling;
  }

  // By whether the tilt above has echo within 1 km along the ray, on one of three rays.
  Mark MarkOf(const std::array<std::size_t, 3>& upper, std::size_t gate) const
  {
    const auto hasEcho = [this, gate](std::size_t place)
    {
      const GateRange range = Common(near[gate], above.Held(place));
      const float* row = above.Row(place);
      return !range.IsEmpty() && std::any_of(row + range.begin, row + range.end, IsNumber);
    };
    return std::any_of(upper.begin(), upper.end(), hasEcho) ? Confirmed : Alone;
  }

  // Marks stand for all gates that can be judged, also for those without echo between others.
  std::size_t MarkIndex(std::size_t place, std::size_t gate) const
  {
    return place * sweep.judged + gate;
  }

  // Gates that are alone, and the gaps of two rays and of widestGapAlongRay between such gates:
  // propagation comes in patches. By EchoGrid::Index.
  std::vector<std::uint8_t> Members() const
  {
    std::vector<std::uint8_t> along(marks.size(), 0);
    std::vector<std::uint8_t> members(grid.Count(), 0);
    for (std::size_t place = 0; place < grid.Rays(); ++place)
    {
      const std::size_t first = this->MarkIndex(place, 0);
      std::size_t reach = 0; // gates that a gate before still makes members
      for (std::size_t gate = 0; gate < sweep.judged; ++gate)
      {
        reach = marks[first + gate] == Alone ? widestGapAlongRay * step + 1 : reach;
        along[first + gate] = reach > 0 && marks[first + gate] != Confirmed ? 1 : 0;
        reach -= reach > 0 ? 1 : 0;
      }
    }
    for (std::size_t place = 0; place < grid.Rays(); ++place)
    {
      const GateRange judged = sweep.Judged(place);
      for (const int beside : {0, 1, 2})
      {
        const std::size_t other = grid.Beside(place, beside);
        for (std::size_t gate = judged.begin; other < grid.Rays() && gate < judged.end; ++gate)
        {
          members[grid.Index(place, gate)] |= marks[this->MarkIndex(place, gate)] != Confirmed
                                                ? along[this->MarkIndex(other, gate)]
                                                : 0;
        }
      }
    }
    return members;
  }

  void JudgeRegions()
  {
    const GateRegions regions(grid, this->Members());
    std::vector<PropagationRegion> all(regions.Count());
    for (const GateRun& run : regions.Runs())
    {
      this->AddRun(run, all[run.region]);
    }
    for (const GateRun& run : regions.Runs())
    {
      const bool propagates = this->IsPropagation(all[run.region]);
      for (std::size_t gate = run.begin; propagates && gate < run.end; ++gate)
      {
        EchoReason& reason = sweep.reasons[grid.Index(run.place, gate)];
        const bool isMarked = marks[this->MarkIndex(run.place, gate)] != Nothing;
        reason =
          isMarked && ClassOf(reason) == EchoClass::Weather ? EchoReason::GroundHeight : reason;
      }
    }
  }

  void AddRun(const GateRun& run, PropagationRegion& region) const
  {
    const float* row = grid.Row(run.place);
    for (std::size_t gate = run.begin; gate < run.end; ++gate)
    {
      const std::size_t index = grid.Index(run.place, gate);
      if (marks[this->MarkIndex(run.place, gate)] != Alone)
      {
        continue;
      }
      ++region.gates;
      region.telling += row[gate] >= needed[gate] ? 1 : 0;
      region.strong += row[gate] >= strongEcho ? 1 : 0;
      const bool flies = sweep.IsPolarimetric() && sweep.flights[index] != FlightSign::None;
      region.doubted += flies || sweep.signs[index] != GroundSign::None ? 1 : 0;
      const float before = gate >= step ? grid.At(run.place, gate - step) : NoNumber;
      if (IsNumber(before))
      {
        const auto difference = static_cast<double>(row[gate] - before);
        region.squares += difference * difference;
        ++region.pairs;
      }
      this->AddOutline(run.place, gate, region);
    }
  }

  void AddOutline(std::size_t place, std::size_t gate, PropagationRegion& region) const
  {
    bool isOutline = false;
    bool isEdge = false;
    for (const int away : {-1, 0, 1})
    {
      const std::size_t beside = grid.Beside(place, away);
      for (std::size_t other = gate - std::min<std::size_t>(1, gate);
           beside < grid.Rays() && other < std::min(gate + 2, sweep.judged); ++other)
      {
        const std::uint8_t mark = marks[this->MarkIndex(beside, other)];
        isOutline = isOutline || mark != Alone;
        isEdge = isEdge || mark == Confirmed;
      }
    }
    region.outline += isOutline ? 1 : 0;
    region.edge += isEdge ? 1 : 0;
  }

  // In gates of 1 km × 1°.
  double AreaOf(std::size_t gates) const
  {
    return static_cast<double>(gates) * grid.GateSpacing() / 1000.0 * 360.0 /
           static_cast<double>(grid.Rays());
  }

  bool IsPropagation(const PropagationRegion& region) const
  {
    const auto gates = static_cast<double>(region.gates);
    const auto telling = static_cast<double>(region.telling);
    if (this->AreaOf(region.telling) < fewestTelling || telling < leastTelling * gates ||
        (sweep.IsPolarimetric() && 2 * region.doubted < region.gates))
    {
      return false;
    }
    const double roughness = region.squares / std::max(1.0, static_cast<double>(region.pairs));
    const double strong = static_cast<double>(region.strong) / gates;
    const double edge = static_cast<double>(region.edge) /
                        static_cast<double>(std::max<std::size_t>(1, region.outline));
    const bool isSurely = roughness > surelyRough && strong > surelyStrong;
    return edge <= (isSurely ? mostSureEdge : mostEdge) &&
           ((roughness > leastRoughness && strong > leastStrong) ||
             (roughness > surelyRough && this->AreaOf(region.gates) > largeArea));
  }

  SweepJudgement& sweep;
  const EchoGrid& grid;
  const EchoGrid& above;
  std::size_t step;            // gates of 1 km along the ray
  std::vector<float> needed;   // dBZ
  std::vector<GateRange> near; // of the tilt above
  std::vector<std::uint8_t> marks;
};

} // namespace

void SearchGround(SweepJudgement& sweep, const SweepSources& sources)
{
  GroundSearcher(sweep, sources).Run();
}

void FindGround(SweepJudgement& sweep)
{
  const GateRegions regions(*sweep.grid, sweep.signs);
  std::vector<GroundRegion> all(regions.Count());
  for (const GateRun& run : regions.Runs())
  {
    AddRun(sweep, run, all[run.region]);
  }
  for (const GateRun& run : regions.Runs())
  {
    for (std::size_t gate = run.begin; gate < run.end && IsGround(all[run.region]); ++gate)
    {
      const std::size_t index = sweep.grid->Index(run.place, gate);
      sweep.reasons[index] = ReasonOf(sweep, index);
    }
  }
}

void FindPropagation(SweepJudgement& sweep)
{
  if (sweep.above != nullptr && sweep.grid->Elevation() <= highestTilt)
  {
    PropagationSearcher(sweep).Run();
  }
}

} // namespace nexrad

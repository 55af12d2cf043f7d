// SPDX-License-Identifier: BSD-3-Clause
#include "nexrad/Quality/GroundTest.h"

#include "nexrad/Quality/EchoGrid.h"
#include "nexrad/Quality/Textures.h"

#include <algorithm>
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
      const GateRange all = this->AllOf(place);
      // Where most gates are asked for, the others may soon be, too.
      wanted[place] = 2 * Length(still) > Length(all) ? all : still;
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
      const std::uint8_t* signs = sweep.signs.data() + sweep.Index(run.place, 0);
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

  static std::size_t Length(const GateRange& range)
  {
    return range.IsEmpty() ? 0 : range.end - range.begin;
  }

  // The gates of a ray that can be judged.
  GateRange AllOf(std::size_t place) const
  {
    const GateRange held = grid.Held(place);
    return {held.begin, std::min(held.end, sweep.judged)};
  }

  bool Lacks(std::size_t place, const GateRange& range) const
  {
    const GateRange all = this->AllOf(place);
    const GateRange needed = {std::max(range.begin, all.begin), std::min(range.end, all.end)};
    return !needed.IsEmpty() &&
           (needed.begin < wanted[place].begin || needed.end > wanted[place].end);
  }

  void WantAllOf(std::size_t place)
  {
    if (place < grid.Rays() && this->Lacks(place, this->AllOf(place)))
    {
      wanted[place] = this->AllOf(place);
      changed[place] = 1;
    }
  }

  SweepJudgement& sweep;
  const EchoGrid& grid;
  const SweepSources& sources;
  std::vector<GateRange> wanted;     // of each row the gates that are judged
  std::vector<std::uint8_t> changed; // rows that are to be judged, again or at all
};

} // namespace

void SearchGround(SweepJudgement& sweep, const SweepSources& sources)
{
  GroundSearcher(sweep, sources).Run();
}

namespace
{

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
  if (place >= sweep.grid->Rays() || gate >= sweep.judged)
  {
    return;
  }
  const std::size_t index = sweep.Index(place, gate);
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
    const std::size_t index = sweep.Index(run.place, gate);
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

EchoReason ReasonOf(const SweepJudgement& sweep, std::size_t index, bool polarimetric)
{
  if (sweep.signs[index] == GroundSign::Sure)
  {
    return polarimetric ? EchoReason::GroundPolarimetry : EchoReason::GroundTexture;
  }
  return sweep.speeds[index] == 0 && sweep.gradients[index] >= surelyGone
           ? EchoReason::GroundHeight
           : EchoReason::GroundRegion;
}

} // namespace

void FindGround(SweepJudgement& sweep, bool polarimetric)
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
      const std::size_t index = sweep.Index(run.place, gate);
      sweep.reasons[index] = ReasonOf(sweep, index, polarimetric);
    }
  }
}

} // namespace nexrad

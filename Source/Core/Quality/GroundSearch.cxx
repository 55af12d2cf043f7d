// SPDX-License-Identifier: BSD-3-Clause
#include "nexrad/Quality/GroundSearch.h"

#include "nexrad/Quality/Evidence/GateRegions.h"
#include "nexrad/Quality/Evidence/Textures.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace nexrad
{

namespace
{

constexpr std::size_t besideRuns = 2;    // gates before and behind a run that FindGround looks at
constexpr std::size_t firstReach = 16;   // gates beyond those that are missing
constexpr std::size_t gatesOfAReach = 8; // for each ray beyond them

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
    for (std::size_t reach = firstReach; this->JudgeChanged(); reach *= 2)
    {
      this->WantGatesAboutGround(reach);
    }
  }

private:
  void WantStillGates()
  {
    const RowGeometry geometry = {sweep.judged, grid.RangeOf(0), grid.GateSpacing()};
    std::vector<std::uint16_t> codes;
    for (std::size_t place = 0; place < grid.Rays(); ++place)
    {
      wanted[place] =
        StillGates(grid.Row(place), sources.velocity, grid.RayAt(place), geometry, codes);
      changed[place] = wanted[place].IsEmpty() ? 0 : 1;
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

  // Wants the gates in and beside regions with sure ground; where some of them have not been
  // judged, as many more as reach.
  void WantGatesAboutGround(std::size_t reach)
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
        this->WantGatesAbout(run, reach);
      }
    }
  }

  void WantGatesAbout(const GateRun& run, std::size_t reach)
  {
    for (const int step : {-1, 0, 1})
    {
      const std::size_t beside = grid.Beside(run.place, step);
      if (beside < grid.Rays() && this->Lacks(beside, About(run, besideRuns)))
      {
        const auto rays = static_cast<int>(reach / gatesOfAReach);
        for (int each = -rays; each <= rays; ++each)
        {
          this->Want(grid.Beside(run.place, each), About(run, reach));
        }
        return;
      }
    }
  }

  static GateRange About(const GateRun& run, std::size_t margin)
  {
    return {run.begin - std::min<std::size_t>(margin, run.begin), run.end + margin};
  }

  // The part of a range that can have a value.
  GateRange Within(std::size_t place, const GateRange& range) const
  {
    const GateRange held = grid.Held(place);
    return {std::max(range.begin, held.begin), std::min({range.end, held.end, sweep.judged})};
  }

  bool Lacks(std::size_t place, const GateRange& range) const
  {
    const GateRange needed = this->Within(place, range);
    return !needed.IsEmpty() &&
           (needed.begin < wanted[place].begin || needed.end > wanted[place].end);
  }

  void Want(std::size_t place, const GateRange& range)
  {
    if (place < grid.Rays() && this->Lacks(place, range))
    {
      wanted[place] = Hull(wanted[place], this->Within(place, range));
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

} // namespace nexrad

// SPDX-License-Identifier: BSD-3-Clause
#include "nexrad/Quality/BiologicalTest.h"

#include "nexrad/Geometry/Angles.h"
#include "nexrad/Quality/Evidence/GateRegions.h"

#include <algorithm>
#include <cstdint>

namespace nexrad
{

namespace
{

constexpr std::size_t sureOfTen = 3;
constexpr float strongest = 20.0F;     // dBZ
constexpr double highest = 2500.0;     // m
constexpr double freeHeight = 3000.0;  // m, where there must be no echo
constexpr double leastArea = 300.0e6;  // m²
constexpr double nearRadar = 40'000.0; // m

// For each gate of a ray up to `highest`: the gate where there must be no echo, of the lowest sweep
// whose beam is as high as freeHeight there.
struct FreeGate
{
  const EchoGrid* grid = nullptr; // nullptr where no beam is
  std::ptrdiff_t gate = 0;
};
std::vector<FreeGate> FindFreeGates(const std::vector<SweepJudgement>& sweeps, const EchoGrid& grid)
{
  std::vector<const EchoGrid*> upward;
  for (const SweepJudgement& sweep : sweeps)
  {
    if (sweep.grid)
    {
      upward.push_back(sweep.grid.get());
    }
  }
  std::stable_sort(upward.begin(), upward.end(),
    [](const EchoGrid* a, const EchoGrid* b) { return a->Elevation() < b->Elevation(); });
  std::vector<FreeGate> free;
  auto above = upward.end(); // the beams from here on are as high
  for (std::size_t gate = 0; gate < grid.Gates(); ++gate)
  {
    const double range = grid.RangeOf(gate);
    if (BeamHeight(range, grid.Elevation()) > highest)
    {
      break;
    }
    while (above != upward.begin() && BeamHeight(range, (*(above - 1))->Elevation()) >= freeHeight)
    {
      --above;
    }
    free.push_back(above == upward.end() ? FreeGate() : FreeGate{*above, (*above)->GateAt(range)});
  }
  return free;
}

// Whether each gate of a row may be clear-air echo.
void MarkRow(const SweepJudgement& sweep, const std::vector<FreeGate>& free, std::size_t place,
  std::uint8_t* members)
{
  const EchoGrid& grid = *sweep.grid;
  const float* row = grid.Row(place);
  const EchoGrid* rowOf = nullptr; // the grid of `upper`
  const float* upper = nullptr;
  for (std::size_t gate = 0; gate < std::min(free.size(), grid.Held(place).end); ++gate)
  {
    const bool weak = IsNumber(row[gate]) && row[gate] < strongest &&
                      sweep.reasons[sweep.Index(place, gate)] == EchoReason::Plain;
    const EchoGrid* above = free[gate].grid;
    if (!weak || !above)
    {
      continue;
    }
    if (above != rowOf)
    {
      const std::size_t beyond = above->PlaceAt(grid.AzimuthAt(place));
      upper = beyond < above->Rays() ? above->Row(beyond) : nullptr;
      rowOf = above;
    }
    const std::ptrdiff_t at = free[gate].gate;
    const bool beyond = at < 0 || at >= static_cast<std::ptrdiff_t>(above->Gates());
    members[gate] = upper && (beyond || !IsNumber(upper[at])) ? 1 : 0;
  }
}

} // namespace

void FindFlight(SweepJudgement& sweep)
{
  const GateRegions regions(*sweep.grid, sweep.flights);
  std::vector<std::size_t> gates(regions.Count(), 0);
  std::vector<std::size_t> sure(regions.Count(), 0);
  for (const GateRun& run : regions.Runs())
  {
    const std::uint8_t* signs = sweep.flights.data() + sweep.Index(run.place, 0);
    gates[run.region] += run.end - run.begin;
    sure[run.region] +=
      static_cast<std::size_t>(std::count(signs + run.begin, signs + run.end, FlightSign::Sure));
  }
  for (const GateRun& run : regions.Runs())
  {
    EchoReason* first = sweep.reasons.data() + sweep.Index(run.place, 0);
    if (10 * sure[run.region] >= sureOfTen * gates[run.region])
    {
      std::fill(first + run.begin, first + run.end, EchoReason::FlightPolarimetry);
    }
  }
}

void FindClearAir(const std::vector<SweepJudgement>& sweeps, SweepJudgement& sweep)
{
  const EchoGrid& grid = *sweep.grid;
  const std::vector<FreeGate> free = FindFreeGates(sweeps, grid);
  std::vector<std::uint8_t> members(sweep.reasons.size(), 0);
  for (std::size_t place = 0; place < grid.Rays(); ++place)
  {
    MarkRow(sweep, free, place, members.data() + sweep.Index(place, 0));
  }
  const GateRegions regions(grid, members);
  std::vector<double> areas(regions.Count(), 0.0);
  std::vector<char> isNear(regions.Count(), 0);
  const double perRange =
    grid.GateSpacing() * 360.0 * RadiansPerDegree / static_cast<double>(grid.Rays());
  for (const GateRun& run : regions.Runs())
  {
    areas[run.region] += perRange * grid.RangeOf((run.begin + run.end) / 2) * (run.end - run.begin);
    isNear[run.region] |= grid.RangeOf(run.begin) < nearRadar ? 1 : 0;
  }
  for (const GateRun& run : regions.Runs())
  {
    if (areas[run.region] >= leastArea && isNear[run.region])
    {
      EchoReason* first = sweep.reasons.data() + sweep.Index(run.place, 0);
      std::fill(first + run.begin, first + run.end, EchoReason::ClearAir);
    }
  }
}

} // namespace nexrad

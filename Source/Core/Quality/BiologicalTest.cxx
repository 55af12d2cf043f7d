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
constexpr double mostHigh = 3.0;       // of the area below `highest`, above it

// A region without echo in the air above it.
struct ClearAirRegion
{
  double low = 0.0;  // m², with the beam up to `highest`
  double high = 0.0; // m², above
  bool isNear = false;
};

// For each gate of a ray that can be judged: the gate where there must be no echo, of the lowest
// sweep above whose beam is as high as freeHeight there.
struct FreeGate
{
  const EchoGrid* grid = nullptr; // nullptr where no beam is
  std::ptrdiff_t gate = 0;
};
std::vector<FreeGate> FindFreeGates(
  const std::vector<SweepJudgement>& sweeps, const SweepJudgement& own)
{
  constexpr double leastRise = 0.5; // degrees: repetitions of a cut are not above it
  const EchoGrid& grid = *own.grid;
  std::vector<const EchoGrid*> upward;
  for (const SweepJudgement& sweep : sweeps)
  {
    if (sweep.grid && sweep.grid->Elevation() > grid.Elevation() + leastRise)
    {
      upward.push_back(sweep.grid.get());
    }
  }
  std::stable_sort(upward.begin(), upward.end(),
    [](const EchoGrid* a, const EchoGrid* b) { return a->Elevation() < b->Elevation(); });
  std::vector<FreeGate> free;
  auto above = upward.end(); // the beams from here on are as high
  for (std::size_t gate = 0; gate < own.judged; ++gate)
  {
    const double range = grid.RangeOf(gate);
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
  const std::vector<FreeGate> free = FindFreeGates(sweeps, sweep);
  std::vector<std::uint8_t> members(sweep.reasons.size(), 0);
  for (std::size_t place = 0; place < grid.Rays(); ++place)
  {
    MarkRow(sweep, free, place, members.data() + sweep.Index(place, 0));
  }
  const GateRegions regions(grid, members);
  std::vector<ClearAirRegion> all(regions.Count());
  const double perRange =
    grid.GateSpacing() * 360.0 * RadiansPerDegree / static_cast<double>(grid.Rays());
  for (const GateRun& run : regions.Runs())
  {
    const double range = grid.RangeOf((run.begin + run.end) / 2);
    ClearAirRegion& region = all[run.region];
    (BeamHeight(range, grid.Elevation()) > highest ? region.high : region.low) +=
      perRange * range * (run.end - run.begin);
    region.isNear = region.isNear || grid.RangeOf(run.begin) < nearRadar;
  }
  for (const GateRun& run : regions.Runs())
  {
    const ClearAirRegion& region = all[run.region];
    if (region.isNear && region.low >= leastArea && region.high <= mostHigh * region.low)
    {
      EchoReason* first = sweep.reasons.data() + sweep.Index(run.place, 0);
      std::fill(first + run.begin, first + run.end, EchoReason::ClearAir);
    }
  }
}

} // namespace nexrad

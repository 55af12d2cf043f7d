// SPDX-License-Identifier: BSD-3-Clause
#include "nexrad/Quality/BiologicalTest.h"

#include "nexrad/Geometry/Angles.h"
#include "nexrad/Quality/Evidence/GateRegions.h"

#include <algorithm>
#include <cstdint>
#include <map>

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

// The lowest sweep whose beam is as high as freeHeight at a range; nullptr where none is.
const EchoGrid* FindFree(const std::vector<SweepJudgement>& sweeps, double range)
{
  const EchoGrid* found = nullptr;
  for (const SweepJudgement& other : sweeps)
  {
    const bool serves = other.grid && BeamHeight(range, other.grid->Elevation()) >= freeHeight;
    found =
      serves && (!found || other.grid->Elevation() < found->Elevation()) ? other.grid.get() : found;
  }
  return found;
}

// For each gate of a ray up to `highest`: the gate where there must be no echo.
struct FreeGate
{
  const EchoGrid* grid = nullptr;
  std::ptrdiff_t gate = 0;
};
std::vector<FreeGate> FindFreeGates(const std::vector<SweepJudgement>& sweeps, const EchoGrid& grid)
{
  std::vector<FreeGate> free;
  for (std::size_t gate = 0; gate < grid.Gates(); ++gate)
  {
    const double range = grid.RangeOf(gate);
    if (BeamHeight(range, grid.Elevation()) > highest)
    {
      break;
    }
    const EchoGrid* above = FindFree(sweeps, range);
    free.push_back({above, above ? above->GateAt(range) : 0});
  }
  return free;
}

// Whether each gate of a row may be clear-air echo.
void MarkRow(const SweepJudgement& sweep, const std::vector<FreeGate>& free, std::size_t place,
  std::uint8_t* members)
{
  const EchoGrid& grid = *sweep.grid;
  const float* row = grid.Row(place);
  std::map<const EchoGrid*, const float*> rows;
  for (std::size_t gate = 0; gate < std::min(free.size(), grid.Held(place).end); ++gate)
  {
    const bool weak = IsNumber(row[gate]) && row[gate] < strongest &&
                      sweep.reasons[sweep.Index(place, gate)] == EchoReason::Plain;
    const EchoGrid* above = free[gate].grid;
    if (!weak || !above)
    {
      continue;
    }
    const auto found = rows.find(above);
    if (found == rows.end())
    {
      const std::size_t beyond = above->PlaceAt(grid.AzimuthAt(place));
      rows[above] = beyond < above->Rays() ? above->Row(beyond) : nullptr;
    }
    const float* upper = rows[above];
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

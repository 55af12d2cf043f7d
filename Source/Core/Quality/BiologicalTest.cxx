// SPDX-License-Identifier: BSD-3-Clause
#include "nexrad/Quality/BiologicalTest.h"

#include "nexrad/Geometry/Angles.h"
#include "nexrad/Quality/Evidence/GateRegions.h"

#include <algorithm>
#include <cstdint>
#include <optional>

namespace nexrad
{

namespace
{

constexpr std::size_t sureOfTen = 3;
constexpr std::size_t fewestUnder = 4; // one in so many gates under echo: the region is weather
constexpr double aboveFlight = 4000.0; // m, where neither birds nor insects fly in numbers
constexpr float echoAloft = 5.0F;      // dBZ
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

// The echo above the gates of a sweep: at each slant range, of the lowest other tilt whose beam is
// as high as asked for.
class EchoAbove
{
public:
  // Of the gates of `grid` up to `count`; `height`: m above the antenna.
  EchoAbove(const std::vector<SweepJudgement>& sweeps, const EchoGrid& theGrid, std::size_t count,
    double height)
    : grid(theGrid)
  {
    constexpr double leastRise = 0.5; // degrees: repetitions of a cut are not above it
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
    auto above = upward.end(); // the beams from here on are as high
    for (std::size_t gate = 0; gate < count; ++gate)
    {
      const double range = grid.RangeOf(gate);
      while (above != upward.begin() && BeamHeight(range, (*(above - 1))->Elevation()) >= height)
      {
        --above;
      }
      gates.push_back(above == upward.end() ? Gate() : Gate{*above, (*above)->GateAt(range)});
    }
  }

  std::size_t Count() const { return gates.size(); }

  // From here on At means the gates of this row.
  void Seek(std::size_t thePlace)
  {
    place = thePlace;
    rowOf = nullptr;
  }

  // dBZ; NoNumber where there is no echo, empty where no beam is.
  std::optional<float> At(std::size_t gate)
  {
    const auto [above, at] = gates[gate];
    if (above == nullptr)
    {
      return std::nullopt;
    }
    if (above != rowOf)
    {
      const std::size_t beyond = above->PlaceAt(grid.AzimuthAt(place));
      row = beyond < above->Rays() ? above->Row(beyond) : nullptr;
      rowOf = above;
    }
    const bool inside = at >= 0 && at < static_cast<std::ptrdiff_t>(above->Gates());
    return row == nullptr ? std::nullopt : std::optional(inside ? row[at] : NoNumber);
  }

private:
  struct Gate
  {
    const EchoGrid* grid = nullptr; // nullptr where no beam is
    std::ptrdiff_t gate = 0;
  };

  const EchoGrid& grid;
  std::vector<Gate> gates;
  std::size_t place = 0;
  const EchoGrid* rowOf = nullptr; // the grid of `row`
  const float* row = nullptr;
};

// Whether each gate of a row may be clear-air echo.
void MarkRow(
  const SweepJudgement& sweep, EchoAbove& above, std::size_t place, std::uint8_t* members)
{
  const float* row = sweep.grid->Row(place);
  const std::size_t end = std::min(above.Count(), sweep.grid->Held(place).end);
  above.Seek(place);
  for (std::size_t gate = 0; gate < end; ++gate)
  {
    if (IsNumber(row[gate]) && row[gate] < strongest &&
        sweep.reasons[sweep.Index(place, gate)] == EchoReason::Plain)
    {
      const std::optional<float> over = above.At(gate);
      members[gate] = over && !IsNumber(*over) ? 1 : 0;
    }
  }
}

// A connected region of gates with signs of flight.
struct FlightRegion
{
  std::size_t gates = 0;
  std::size_t sure = 0;
  std::size_t under = 0; // below echo where neither birds nor insects fly

  bool IsFlight() const { return 10 * sure >= sureOfTen * gates && fewestUnder * under < gates; }
};

// Counts the gates of a run, and marks those under echo.
void AddRun(SweepJudgement& sweep, EchoAbove& above, const GateRun& run, FlightRegion& region)
{
  std::uint8_t* signs = sweep.flights.data() + sweep.Index(run.place, 0);
  above.Seek(run.place);
  for (std::size_t gate = run.begin; gate < run.end; ++gate)
  {
    ++region.gates;
    region.sure += signs[gate] == FlightSign::Sure ? 1 : 0;
    if (above.At(gate).value_or(NoNumber) >= echoAloft)
    {
      signs[gate] = FlightSign::UnderEcho;
      ++region.under;
    }
  }
}

} // namespace

void FindFlight(const std::vector<SweepJudgement>& sweeps, SweepJudgement& sweep)
{
  const GateRegions regions(*sweep.grid, sweep.flights);
  EchoAbove above(sweeps, *sweep.grid, sweep.judged, aboveFlight);
  std::vector<FlightRegion> all(regions.Count());
  for (const GateRun& run : regions.Runs())
  {
    AddRun(sweep, above, run, all[run.region]);
  }
  for (const GateRun& run : regions.Runs())
  {
    const std::size_t first = sweep.Index(run.place, 0);
    for (std::size_t gate = run.begin; gate < run.end && all[run.region].IsFlight(); ++gate)
    {
      EchoReason& reason = sweep.reasons[first + gate];
      const bool under = sweep.flights[first + gate] == FlightSign::UnderEcho;
      reason = under ? reason : EchoReason::FlightPolarimetry;
    }
  }
}

void FindClearAir(const std::vector<SweepJudgement>& sweeps, SweepJudgement& sweep)
{
  const EchoGrid& grid = *sweep.grid;
  EchoAbove above(sweeps, grid, sweep.judged, freeHeight);
  std::vector<std::uint8_t> members(sweep.reasons.size(), 0);
  for (std::size_t place = 0; place < grid.Rays(); ++place)
  {
    MarkRow(sweep, above, place, members.data() + sweep.Index(place, 0));
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

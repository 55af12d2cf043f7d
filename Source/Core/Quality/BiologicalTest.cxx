// SPDX-License-Identifier: BSD-3-Clause
#include "nexrad/Quality/BiologicalTest.h"

#include "nexrad/Geometry/Angles.h"
#include "nexrad/Quality/EchoGrid.h"

#include <algorithm>
#include <cstdint>

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
      this->AddGate(gate, above == upward.end() ? nullptr : *above);
    }
  }

  // Reads dBZ above the gates of a range of a row; NoNumber where there is no echo.
  void Read(std::size_t place, const GateRange& range, std::vector<float>& values) const
  {
    values.resize(range.Size());
    for (const Part& part : parts)
    {
      const std::size_t begin = std::max(range.begin, part.gates.begin);
      const std::size_t end = std::min(range.end, part.gates.end);
      if (begin < end)
      {
        this->ReadPart(part, place, {begin, end}, values.data() + (begin - range.begin));
      }
    }
  }

  static constexpr float NoBeam = -NoNumber; // above any echo: no beam is there

private:
  // Gates below one tilt, and whether its rays have gates there; nullptr where there is none.
  struct Part
  {
    const EchoGrid* grid;
    bool inside;
    GateRange gates;
    bool abreast; // the gates above them follow each other as they do
  };

  void AddGate(std::size_t gate, const EchoGrid* above)
  {
    const std::ptrdiff_t at = above ? above->GateAt(grid.RangeOf(gate)) : -1;
    const bool inside = at >= 0 && at < static_cast<std::ptrdiff_t>(above ? above->Gates() : 0);
    gates.push_back(inside ? static_cast<std::size_t>(at) : 0);
    if (parts.empty() || parts.back().grid != above || parts.back().inside != inside)
    {
      parts.push_back({above, inside, {gate, gate}, true});
    }
    Part& part = parts.back();
    part.gates.end = gate + 1;
    const std::size_t first = part.gates.begin;
    part.abreast = part.abreast && gates[gate] - gates[first] == gate - first;
  }

  // Some gates of a part.
  void ReadPart(const Part& part, std::size_t place, const GateRange& range, float* to) const
  {
    const std::size_t count = range.end - range.begin;
    const std::size_t beyond = part.grid ? part.grid->PlaceAt(grid.AzimuthAt(place)) : 0;
    if (part.grid == nullptr || beyond == part.grid->Rays())
    {
      std::fill_n(to, count, NoBeam);
      return;
    }
    if (!part.inside)
    {
      std::fill_n(to, count, NoNumber);
      return;
    }
    if (part.abreast)
    {
      const std::size_t first = gates[range.begin];
      part.grid->Read(beyond, {first, first + count}, to);
      return;
    }
    for (std::size_t gate = range.begin; gate < range.end; ++gate)
    {
      to[gate - range.begin] = part.grid->At(beyond, gates[gate]);
    }
  }

  const EchoGrid& grid;
  std::vector<std::size_t> gates; // of the tilt above, for each gate inside it
  std::vector<Part> parts;
};

// Whether each gate of a row may be clear-air echo. `over` is room that is used.
void MarkRow(const SweepJudgement& sweep, const EchoAbove& above, std::size_t place,
  std::vector<float>& over, std::vector<std::uint8_t>& members)
{
  const GateRange range = sweep.Judged(place);
  above.Read(place, range, over);
  const std::size_t first = sweep.grid->Index(place, range.begin);
  const float* row = sweep.grid->Row(place) + range.begin;
  for (std::size_t i = 0; i < over.size(); ++i)
  {
    const bool weak = row[i] < strongest; // and plain weather, so that there is a number
    const bool free = !IsNumber(over[i]);
    const bool plain = sweep.reasons[first + i] == EchoReason::Plain;
    members[first + i] = weak & free & plain ? 1 : 0;
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

// Counts the gates of a run, and marks those under echo. `over` is room that is used.
void AddRun(SweepJudgement& sweep, const EchoAbove& above, const GateRun& run,
  std::vector<float>& over, FlightRegion& region)
{
  std::uint8_t* signs = sweep.flights.data() + sweep.grid->Index(run.place, run.begin);
  above.Read(run.place, {run.begin, run.end}, over);
  for (std::size_t i = 0; i < over.size(); ++i)
  {
    ++region.gates;
    region.sure += signs[i] == FlightSign::Sure ? 1 : 0;
    if (over[i] >= echoAloft && over[i] < EchoAbove::NoBeam)
    {
      signs[i] = FlightSign::UnderEcho;
      ++region.under;
    }
  }
}

} // namespace

void FindFlight(const std::vector<SweepJudgement>& sweeps, SweepJudgement& sweep)
{
  const GateRegions regions(*sweep.grid, sweep.flights);
  const EchoAbove above(sweeps, *sweep.grid, sweep.judged, aboveFlight);
  std::vector<float> over;
  std::vector<FlightRegion> all(regions.Count());
  for (const GateRun& run : regions.Runs())
  {
    AddRun(sweep, above, run, over, all[run.region]);
  }
  for (const GateRun& run : regions.Runs())
  {
    const std::size_t first = sweep.grid->Index(run.place, 0);
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
  const EchoAbove above(sweeps, grid, sweep.judged, freeHeight);
  std::vector<float> over;
  std::vector<std::uint8_t> members(sweep.reasons.size(), 0);
  for (std::size_t place = 0; place < grid.Rays(); ++place)
  {
    MarkRow(sweep, above, place, over, members);
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
      EchoReason* first = sweep.reasons.data() + grid.Index(run.place, 0);
      std::fill(first + run.begin, first + run.end, EchoReason::ClearAir);
    }
  }
}

} // namespace nexrad

// SPDX-License-Identifier: BSD-3-Clause
#include "nexrad/Quality/SpeckleTest.h"

#include "nexrad/Quality/EchoGrid.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace nexrad
{

namespace
{

constexpr std::size_t fewGates = 3;

// Whether a gate is weather or biological echo. The compiler compares several at once.
bool Stays(EchoReason reason)
{
  const bool weather = (reason >= EchoReason::Plain) & (reason <= EchoReason::Debris);
  const bool biological =
    (reason >= EchoReason::FlightPolarimetry) & (reason <= EchoReason::ClearAir);
  return weather | biological;
}

} // namespace

void FindSpeckle(SweepJudgement& sweep)
{
  std::vector<std::uint8_t> members(sweep.reasons.size(), 0);
  for (std::size_t place = 0; place < sweep.grid->Rays(); ++place)
  {
    const GateRange held = sweep.grid->Held(place);
    const EchoReason* reasons = sweep.reasons.data() + sweep.Index(place, 0);
    std::transform(reasons + held.begin, reasons + held.end,
      members.data() + sweep.Index(place, held.begin),
      [](EchoReason reason) -> std::uint8_t { return Stays(reason) ? 1 : 0; });
  }
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
      EchoReason* first = sweep.reasons.data() + sweep.Index(run.place, 0);
      std::fill(first + run.begin, first + run.end, EchoReason::FewGates);
    }
  }
}

} // namespace nexrad

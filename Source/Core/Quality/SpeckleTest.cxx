// SPDX-License-Identifier: BSD-3-Clause
#include "nexrad/Quality/SpeckleTest.h"

#include "nexrad/Quality/Evidence/GateRegions.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace nexrad
{

namespace
{

constexpr std::size_t fewGates = 3;

} // namespace

void FindSpeckle(SweepJudgement& sweep)
{
  std::array<std::uint8_t, EchoReasonCount> stays{};
  for (std::size_t reason = 0; reason < EchoReasonCount; ++reason)
  {
    const EchoClass echoClass = ClassOf(static_cast<EchoReason>(reason));
    stays[reason] = echoClass == EchoClass::Weather || echoClass == EchoClass::Biological ? 1 : 0;
  }
  std::vector<std::uint8_t> members(sweep.reasons.size());
  std::transform(sweep.reasons.begin(), sweep.reasons.end(), members.begin(),
    [&stays](EchoReason reason) { return stays[static_cast<std::size_t>(reason)]; });
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

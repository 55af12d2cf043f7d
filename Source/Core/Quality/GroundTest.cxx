// SPDX-License-Identifier: BSD-3-Clause
#include "nexrad/Quality/GroundTest.h"

#include "nexrad/Quality/GateRegions.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace nexrad
{

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

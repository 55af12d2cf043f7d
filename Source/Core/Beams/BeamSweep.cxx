// SPDX-License-Identifier: BSD-3-Clause
#include "nexrad/Beams/BeamSweep.h"

#include <algorithm>
#include <cmath>

namespace nexrad
{

int NearestEntry(const BeamSweep& sweep, float azimuth)
{
  const std::size_t entry = sweep.EntryBefore(azimuth);
  const float from = azimuth - sweep.azimuths[entry];
  const float to = sweep.azimuths[entry + 1] - azimuth;
  if (sweep.inverseGaps[entry] <= 0.0F && from > sweep.halfWidth && to > sweep.halfWidth)
  {
    return -1;
  }
  return static_cast<int>(to < from ? entry + 1 : entry);
}

CodeRange FindValueCodes(const BeamSweep& sweep)
{
  CodeRange range;
  for (std::size_t entry = 0; entry < sweep.held.size(); ++entry)
  {
    const std::uint16_t* codes = sweep.Row(entry);
    // Without a branch, so that the compiler can put codes side by side: codes of states turn into
    // the largest places.
    std::uint16_t least = GateCode::Last;
    std::uint16_t most = 0;
    for (std::size_t gate = sweep.held[entry].begin; gate < sweep.held[entry].end; ++gate)
    {
      const auto place = static_cast<std::uint16_t>(codes[gate] - GateCode::FirstValue);
      least = std::min(least, place);
      most = std::max(most, codes[gate]);
    }
    range.most = std::max(range.most, most);
    range.least = std::min<std::uint16_t>(
      range.least, std::min<unsigned>(least + unsigned(GateCode::FirstValue), GateCode::Last));
  }
  return range;
}

double RangeOf(const BeamSweep& sweep, int gate)
{
  return static_cast<double>(sweep.firstGate) + gate / static_cast<double>(sweep.gatesPerMetre);
}

double RangeOver(const BeamSweep& sweep, double groundDistance, const BeamModel& beam)
{
  const double height = beam.HeightOver(groundDistance, static_cast<double>(sweep.elevation));
  return beam.Look({height, groundDistance}).slantRange;
}

std::vector<int> GatesOver(const BeamSweep& sweep, const BeamSweep& other, const BeamModel& beam)
{
  const auto gateAt = [&sweep](double range)
  {
    const double place =
      (range - static_cast<double>(sweep.firstGate)) * static_cast<double>(sweep.gatesPerMetre);
    return place >= -0.5 && place < sweep.gates - 0.5 ? static_cast<int>(std::lround(place)) : -1;
  };
  std::vector<int> gates;
  for (int gate = 0; gate < other.gates; ++gate)
  {
    const double range = RangeOf(other, gate);
    const BeamPoint point = beam.Locate(range, static_cast<double>(other.elevation));
    gates.push_back(range > 0.0 ? gateAt(RangeOver(sweep, point.groundDistance, beam)) : -1);
  }
  return gates;
}

} // namespace nexrad

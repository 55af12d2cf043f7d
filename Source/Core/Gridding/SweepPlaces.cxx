// SPDX-License-Identifier: BSD-3-Clause
#include "Gridding/SweepPlaces.h"

#include "Geometry/Beam.h"
#include "Gridding/BeamVolume.h"

#include <algorithm>
#include <cmath>

namespace nexrad
{

int NearestEntry(const BeamSweep& sweep, float azimuth)
{
  std::size_t entry =
    sweep.firstEntries[static_cast<std::size_t>(azimuth * BeamSweep::BinsPerDegree)];
  while (sweep.azimuths[entry + 1] <= azimuth)
  {
    ++entry;
  }
  const float from = azimuth - sweep.azimuths[entry];
  const float to = sweep.azimuths[entry + 1] - azimuth;
  if (sweep.inverseGaps[entry] <= 0.0F && from > sweep.halfWidth && to > sweep.halfWidth)
  {
    return -1;
  }
  return static_cast<int>(to < from ? entry + 1 : entry);
}

std::uint16_t LargestCode(const BeamSweep& sweep, std::size_t entry)
{
  const std::uint16_t* codes = sweep.codes.data() + entry * sweep.Stride();
  std::uint16_t largest = 0;
  for (std::size_t gate = 0; gate < sweep.Stride(); ++gate)
  {
    largest = std::max(largest, codes[gate]);
  }
  return largest;
}

int GateAt(const BeamSweep& sweep, double slantRange)
{
  const double place =
    (slantRange - static_cast<double>(sweep.firstGate)) * static_cast<double>(sweep.gatesPerMetre);
  return place >= -0.5 && place < sweep.gates - 0.5 ? static_cast<int>(std::lround(place)) : -1;
}

double RangeOver(const BeamSweep& sweep, double arc, double effectiveRadius)
{
  const double t = std::tan(0.5 * arc);
  return effectiveRadius * 2.0 * t /
         (static_cast<double>(sweep.cosine) * (1.0 - t * t) -
           2.0 * static_cast<double>(sweep.sine) * t);
}

std::vector<int> GatesOver(const BeamSweep& sweep, const BeamSweep& other)
{
  const double radius = BeamModel().EffectiveRadius();
  std::vector<int> gates;
  for (int gate = 0; gate < other.gates; ++gate)
  {
    const double range = static_cast<double>(other.firstGate) +
                         static_cast<double>(gate) / static_cast<double>(other.gatesPerMetre);
    const double arc = std::atan2(
      range * static_cast<double>(other.cosine), radius + range * static_cast<double>(other.sine));
    gates.push_back(range > 0.0 ? GateAt(sweep, RangeOver(sweep, arc, radius)) : -1);
  }
  return gates;
}

} // namespace nexrad

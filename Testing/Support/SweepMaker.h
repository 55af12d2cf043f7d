// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "nexrad/Polar/PolarVolume.h"

#include <cmath>
#include <limits>
#include <utility>
#include <vector>

namespace nexrad::testing
{

/// A sweep of evenly turned rays, all gates below threshold.
inline PolarSweep MakeSweep(
  int number, double elevation, std::size_t rays, std::size_t gates, double gateSpacing = 1000.0)
{
  PolarSweep sweep;
  sweep.elevationNumber = number;
  sweep.firstGate = gateSpacing;
  sweep.gateSpacing = gateSpacing;
  sweep.gates = gates;
  for (std::size_t i = 0; i < rays; ++i)
  {
    sweep.rays.push_back({360.0 * static_cast<double>(i) / static_cast<double>(rays), elevation});
  }
  sweep.values.assign(rays * gates, std::numeric_limits<float>::quiet_NaN());
  sweep.states.assign(rays * gates, GateState::BelowThreshold);
  return sweep;
}

/// Makes a gate valid with a value.
inline void SetGate(PolarSweep& sweep, std::size_t ray, std::size_t gate, float value)
{
  sweep.values[sweep.Index(ray, gate)] = value;
  sweep.states[sweep.Index(ray, gate)] = GateState::Valid;
}

/// Makes all gates valid with a value.
inline void SetAll(PolarSweep& sweep, float value)
{
  sweep.values.assign(sweep.values.size(), value);
  sweep.states.assign(sweep.states.size(), GateState::Valid);
}

/// A volume of one site that started `seconds` after 2006-03-12T18:00Z.
inline PolarVolume MakeVolume(
  const Position& position, double seconds, std::vector<PolarSweep> sweeps)
{
  PolarVolume volume;
  volume.site = {"KTST", position};
  volume.start = *ParseIso8601("2006-03-12T18:00Z") + Duration(std::llround(seconds * 1000.0));
  volume.end = volume.start + Duration(240'000);
  volume.sweeps = std::move(sweeps);
  return volume;
}

} // namespace nexrad::testing

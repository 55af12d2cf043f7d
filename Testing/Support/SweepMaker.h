// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "nexrad/Polar/PolarVolume.h"

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

namespace nexrad::testing
{

/// The gates of a sweep as numbers, to make one from and to look at one: a value and a state each,
/// rays × gates, gates fastest.
struct NumberSweep
{
  int elevationNumber = 0;
  double firstGate = 0.0;   ///< m
  double gateSpacing = 0.0; ///< m
  std::size_t gates = 0;
  std::vector<PolarRay> rays;
  std::vector<float> values; ///< NaN where the state is not Valid
  std::vector<GateState> states;
  Waveform waveform = Waveform::Unknown;

  std::size_t Index(std::size_t ray, std::size_t gate) const { return ray * gates + gate; }

  /// Rounds the values as SetGates does, and does it for the rays that there are.
  operator PolarSweep() const // NOLINT: a maker of sweeps is meant to serve as one
  {
    PolarSweep sweep;
    sweep.elevationNumber = elevationNumber;
    sweep.firstGate = firstGate;
    sweep.gateSpacing = gateSpacing;
    sweep.gates = gates;
    sweep.rays = rays;
    sweep.waveform = waveform;
    const auto count = static_cast<std::ptrdiff_t>(rays.size() * gates);
    SetGates(
      sweep, {values.begin(), values.begin() + count}, {states.begin(), states.begin() + count});
    return sweep;
  }
};

/// The numbers that a sweep holds.
inline NumberSweep NumbersOf(const PolarSweep& sweep)
{
  NumberSweep numbers{sweep.elevationNumber, sweep.firstGate, sweep.gateSpacing, sweep.gates,
    sweep.rays, {}, {}, sweep.waveform};
  std::vector<std::uint16_t> codes(sweep.gates);
  for (std::size_t ray = 0; ray < sweep.rays.size(); ++ray)
  {
    sweep.Read(ray, codes.data());
    for (const std::uint16_t code : codes)
    {
      constexpr GateState states[] = {GateState::BelowThreshold, GateState::RangeFolded,
        GateState::NotSampled, GateState::NotSampled}; // Filtered
      const bool valid = code >= GateCode::FirstValue;
      numbers.states.push_back(valid ? GateState::Valid : states[code]);
      numbers.values.push_back(
        valid ? sweep.scale.ValueOf(code) : std::numeric_limits<float>::quiet_NaN());
    }
  }
  return numbers;
}

/// Changes the gates of a sweep, which `change` gets as numbers.
template <class Change>
void ChangeGates(PolarSweep& sweep, const Change& change)
{
  NumberSweep numbers = NumbersOf(sweep);
  change(numbers);
  sweep = numbers;
}

/// A sweep of evenly turned rays, all gates below threshold.
inline NumberSweep MakeSweep(
  int number, double elevation, std::size_t rays, std::size_t gates, double gateSpacing = 1000.0)
{
  NumberSweep sweep;
  sweep.elevationNumber = number;
  sweep.firstGate = gateSpacing;
  sweep.gateSpacing = gateSpacing;
  sweep.gates = gates;
  for (std::size_t i = 0; i < rays; ++i)
  {
    const double azimuth = 360.0 * static_cast<double>(i) / static_cast<double>(rays);
    sweep.rays.push_back({static_cast<float>(azimuth), static_cast<float>(elevation)});
  }
  sweep.values.assign(rays * gates, std::numeric_limits<float>::quiet_NaN());
  sweep.states.assign(rays * gates, GateState::BelowThreshold);
  return sweep;
}

/// Makes a gate valid with a value.
inline void SetGate(NumberSweep& sweep, std::size_t ray, std::size_t gate, float value)
{
  sweep.values[sweep.Index(ray, gate)] = value;
  sweep.states[sweep.Index(ray, gate)] = GateState::Valid;
}

/// Makes all gates valid with a value.
inline void SetAll(NumberSweep& sweep, float value)
{
  sweep.values.assign(sweep.values.size(), value);
  sweep.states.assign(sweep.states.size(), GateState::Valid);
}

/// Gives all gates a state.
inline void SetAll(NumberSweep& sweep, GateState state)
{
  sweep.states.assign(sweep.states.size(), state);
}

/// As the merges take volumes, which must outlive the pointers.
inline std::vector<const PolarVolume*> PointersTo(const std::vector<PolarVolume>& volumes)
{
  std::vector<const PolarVolume*> pointers;
  for (const PolarVolume& volume : volumes)
  {
    pointers.push_back(&volume);
  }
  return pointers;
}

/// A volume of one site that started `seconds` after 2006-03-12T18:00Z.
inline PolarVolume MakeVolume(
  const Position& position, double seconds, const std::vector<NumberSweep>& sweeps)
{
  PolarVolume volume;
  volume.site = {"KTST", position};
  volume.start = *ParseIso8601("2006-03-12T18:00Z") + Duration(std::llround(seconds * 1000.0));
  volume.end = volume.start + Duration(240'000);
  volume.sweeps.assign(sweeps.begin(), sweeps.end());
  return volume;
}

} // namespace nexrad::testing

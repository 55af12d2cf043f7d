// SPDX-License-Identifier: BSD-3-Clause
#include "nexrad/Moments/PhaseSlopes.h"

#include "nexrad/Velocity/DifferentialPhase.h"

#include <cmath>
#include <cstddef>
#include <limits>
#include <map>
#include <tuple>
#include <utility>
#include <vector>

namespace nexrad
{

namespace
{

constexpr float none = std::numeric_limits<float>::quiet_NaN();

// Finds the values of a moment at the gates of rays of another one.
class RayValues
{
public:
  explicit RayValues(const PolarVolume& volume)
  {
    for (const PolarSweep& sweep : volume.sweeps)
    {
      for (std::size_t ray = 0; ray < sweep.rays.size(); ++ray)
      {
        places.emplace(KeyOf(sweep, sweep.rays[ray]), std::pair(&sweep, ray));
      }
    }
  }

  // NaN where the moment has no value.
  std::vector<float> At(const PolarSweep& sweep, const PolarRay& ray)
  {
    std::vector<float> values(sweep.gates, none);
    const auto place = places.find(KeyOf(sweep, ray));
    if (place == places.end())
    {
      return values;
    }
    const PolarSweep& own = *place->second.first;
    codes.resize(own.gates);
    own.Read(place->second.second, codes.data());
    for (std::size_t gate = 0; gate < values.size(); ++gate)
    {
      const double range = sweep.firstGate + sweep.gateSpacing * static_cast<double>(gate);
      const double at = std::floor((range - own.firstGate) / own.gateSpacing + 0.5);
      if (at >= 0.0 && at < static_cast<double>(own.gates))
      {
        const std::uint16_t code = codes[static_cast<std::size_t>(at)];
        values[gate] = code >= GateCode::FirstValue ? own.scale.ValueOf(code) : none;
      }
    }
    return values;
  }

private:
  using Key = std::tuple<int, float, Time>;

  static Key KeyOf(const PolarSweep& sweep, const PolarRay& ray)
  {
    return {sweep.elevationNumber, ray.azimuth, ray.time};
  }

  std::map<Key, std::pair<const PolarSweep*, std::size_t>> places;
  std::vector<std::uint16_t> codes;
};

PolarSweep MakeSweep(const PolarSweep& phase, RayValues& reflectivity, RayValues& correlation)
{
  std::vector<float> values;
  std::vector<GateState> states;
  std::vector<std::uint16_t> codes(phase.gates);
  for (std::size_t ray = 0; ray < phase.rays.size(); ++ray)
  {
    phase.Read(ray, codes.data());
    const std::vector<float> correlations = correlation.At(phase, phase.rays[ray]);
    std::vector<float> phases(phase.gates, none);
    for (std::size_t gate = 0; gate < phase.gates; ++gate)
    {
      const bool counts =
        codes[gate] >= GateCode::FirstValue && !(correlations[gate] < LeastPhaseCorrelation);
      phases[gate] = counts ? phase.scale.ValueOf(codes[gate]) : none;
    }
    const std::vector<float> slopes =
      SpecificDifferentialPhase(phases, reflectivity.At(phase, phase.rays[ray]), phase.gateSpacing);
    values.insert(values.end(), slopes.begin(), slopes.end());
    for (std::size_t gate = 0; gate < phase.gates; ++gate)
    {
      const GateState state = StateOf(codes[gate]);
      const bool unknown = state == GateState::Valid && std::isnan(slopes[gate]);
      states.push_back(unknown ? GateState::NotSampled : state);
    }
  }
  PolarSweep sweep = phase;
  SetGates(sweep, values, states);
  return sweep;
}

} // namespace

PolarVolume MakePhaseSlopes(
  const PolarVolume& phase, const PolarVolume& reflectivity, const PolarVolume& correlation)
{
  RayValues reflectivities(reflectivity);
  RayValues correlations(correlation);
  PolarVolume volume = phase;
  volume.moment = MomentName::KDP;
  for (PolarSweep& sweep : volume.sweeps)
  {
    sweep = MakeSweep(sweep, reflectivities, correlations);
  }
  return volume;
}

} // namespace nexrad

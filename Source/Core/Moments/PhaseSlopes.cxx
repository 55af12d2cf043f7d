// SPDX-License-Identifier: BSD-3-Clause
#include "nexrad/Moments/PhaseSlopes.h"

#include "nexrad/System/Error.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <limits>
#include <map>
#include <tuple>
#include <utility>
#include <vector>

namespace nexrad
{

namespace
{

constexpr std::size_t medianReach = 2; // gates to both sides
constexpr std::size_t shortReach = 4;
constexpr std::size_t longReach = 12;
constexpr std::size_t widestGapOfPhase = 4; // gates without a phase within a stretch
constexpr float strongEcho = 40.0F;         // dBZ
constexpr float none = std::numeric_limits<float>::quiet_NaN();

struct Span
{
  std::size_t begin;
  std::size_t end;
};

// Each phase within half a turn of the last one before it.
std::vector<float> WithoutTurns(std::vector<float> phase)
{
  float last = none;
  for (float& value : phase)
  {
    if (!std::isnan(value))
    {
      value = std::isnan(last) ? value : last + std::remainder(value - last, 360.0F);
      last = value;
    }
  }
  return phase;
}

std::vector<float> Medians(const std::vector<float>& phase)
{
  std::vector<float> result(phase.size(), none);
  std::vector<float> about;
  for (std::size_t gate = 0; gate < phase.size(); ++gate)
  {
    if (!std::isnan(phase[gate]))
    {
      const std::size_t begin = gate - std::min(gate, medianReach);
      const std::size_t end = std::min(gate + medianReach + 1, phase.size());
      about.clear();
      std::copy_if(phase.begin() + std::ptrdiff_t(begin), phase.begin() + std::ptrdiff_t(end),
        std::back_inserter(about), [](float value) { return !std::isnan(value); });
      const auto middle = about.begin() + std::ptrdiff_t(about.size() / 2);
      std::nth_element(about.begin(), middle, about.end());
      result[gate] = *middle;
    }
  }
  return result;
}

// The stretch that each gate with a phase is in.
std::vector<Span> FindStretches(const std::vector<float>& phase)
{
  std::vector<Span> stretches(phase.size(), {0, 0});
  std::size_t begin = 0;
  std::size_t end = 0;
  const auto finish = [&]
  {
    std::fill(stretches.begin() + std::ptrdiff_t(begin), stretches.begin() + std::ptrdiff_t(end),
      Span{begin, end});
  };
  for (std::size_t gate = 0; gate < phase.size(); ++gate)
  {
    if (std::isnan(phase[gate]))
    {
      continue;
    }
    if (end == 0 || gate - end > widestGapOfPhase)
    {
      finish();
      begin = gate;
    }
    end = gate + 1;
  }
  finish();
  return stretches;
}

// The window about a gate, moved as far as it must to lie within the stretch.
Span WindowWithin(const Span& stretch, std::size_t gate, std::size_t reach)
{
  const std::size_t length = 2 * reach + 1;
  if (stretch.end - stretch.begin <= length)
  {
    return stretch;
  }
  const std::size_t wanted = gate < reach ? 0 : gate - reach;
  const std::size_t begin = std::clamp(wanted, stretch.begin, stretch.end - length);
  return {begin, begin + length};
}

struct Line
{
  double value = 0.0; // at the gate
  double slope = 0.0; // a gate
  double rms = 0.0;   // of the values about the line
  bool known = false;
};

// The straight line through the values of the window about a gate; not known with less than half of
// them.
Line FitLine(
  const std::vector<float>& values, const Span& stretch, std::size_t gate, std::size_t reach)
{
  const Span window = WindowWithin(stretch, gate, reach);
  double count = 0.0;
  double sx = 0.0;
  double sy = 0.0;
  double sxx = 0.0;
  double sxy = 0.0;
  double syy = 0.0;
  for (std::size_t place = window.begin; place < window.end; ++place)
  {
    if (!std::isnan(values[place]))
    {
      const double x = static_cast<double>(place) - static_cast<double>(gate);
      const auto y = static_cast<double>(values[place]);
      count += 1.0;
      sx += x;
      sy += y;
      sxx += x * x;
      sxy += x * y;
      syy += y * y;
    }
  }
  const double spread = count * sxx - sx * sx;
  if (2.0 * count < static_cast<double>(2 * reach + 1) || !(spread > 0.0))
  {
    return {};
  }
  const double slope = (count * sxy - sx * sy) / spread;
  const double value = (sy - slope * sx) / count;
  const double squares = syy - value * sy - slope * sxy;
  return {value, slope, std::sqrt(std::max(0.0, squares / count)), true};
}

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

// Makes slopes of the phases of a sweep.
void SetSlopes(PolarSweep& sweep, RayValues& reflectivity, RayValues& correlation)
{
  std::vector<float> values;
  std::vector<GateState> states;
  std::vector<std::uint16_t> codes(sweep.gates);
  for (std::size_t ray = 0; ray < sweep.rays.size(); ++ray)
  {
    sweep.Read(ray, codes.data());
    const std::vector<float> correlations = correlation.At(sweep, sweep.rays[ray]);
    std::vector<float> phases(sweep.gates, none);
    for (std::size_t gate = 0; gate < sweep.gates; ++gate)
    {
      const bool counts =
        codes[gate] >= GateCode::FirstValue && !(correlations[gate] < LeastPhaseCorrelation);
      phases[gate] = counts ? sweep.scale.ValueOf(codes[gate]) : none;
    }
    const std::vector<float> slopes =
      SpecificDifferentialPhase(phases, reflectivity.At(sweep, sweep.rays[ray]), sweep.gateSpacing);
    values.insert(values.end(), slopes.begin(), slopes.end());
    std::transform(codes.begin(), codes.end(), std::back_inserter(states), StateOf);
  }
  SetGates(sweep, values, states);
}

} // namespace

std::vector<float> SpecificDifferentialPhase(
  const std::vector<float>& phase, const std::vector<float>& reflectivity, double gateSpacing)
{
  if (phase.size() != reflectivity.size() || !(gateSpacing > 0.0))
  {
    throw Error(
      "K_DP needs a phase and a reflectivity for each gate, and a gate spacing above 0 m");
  }
  const std::vector<float> medians = Medians(WithoutTurns(phase));
  const auto reachAt = [&](std::size_t gate)
  { return reflectivity[gate] > strongEcho ? shortReach : longReach; };
  const std::vector<Span> stretches = FindStretches(phase);
  std::vector<float> smooth(phase.size(), none);
  for (std::size_t gate = 0; gate < phase.size(); ++gate)
  {
    const Line line = FitLine(medians, stretches[gate], gate, reachAt(gate));
    smooth[gate] =
      line.known && line.rms <= LargestPhaseSpread ? static_cast<float>(line.value) : none;
  }
  std::vector<float> result(phase.size(), none);
  for (std::size_t gate = 0; gate < phase.size(); ++gate)
  {
    const Line line = FitLine(smooth, stretches[gate], gate, reachAt(gate));
    if (line.known && !std::isnan(phase[gate]))
    {
      result[gate] = static_cast<float>(0.5 * line.slope * 1000.0 / gateSpacing);
    }
  }
  return result;
}

PolarVolume MakePhaseSlopes(
  const PolarVolume& phase, const PolarVolume& reflectivity, const PolarVolume& correlation)
{
  RayValues reflectivities(reflectivity);
  RayValues correlations(correlation);
  PolarVolume volume = phase;
  volume.moment = MomentName::KDP;
  for (PolarSweep& sweep : volume.sweeps)
  {
    SetSlopes(sweep, reflectivities, correlations);
  }
  return volume;
}

} // namespace nexrad

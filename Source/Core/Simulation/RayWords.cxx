// SPDX-License-Identifier: BSD-3-Clause
#include "nexrad/Simulation/RayWords.h"

#include "nexrad/Simulation/Basis/CounterNoise.h"
#include "nexrad/Simulation/ScanStrategy.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace nexrad
{

namespace
{

constexpr double nothing = -std::numeric_limits<double>::infinity();
constexpr double overlayThreshold = 5.0; // dB by which one of two overlaid echoes must be stronger
constexpr double velocityNoise = 1.2;    // m/s, standard deviation
constexpr double widthNoise = 0.9;       // m/s, standard deviation

constexpr double sensitivityRange = 50'000.0; // m, where options give the sensitivity
constexpr double nearestRange = 250.0;        // m, nearer gates count as there

constexpr std::uint8_t belowThreshold = 0;
constexpr std::uint8_t rangeFolded = 1;

// Numbers of the noise streams within a ray.
constexpr std::uint64_t reflectivityStream = 0;
constexpr std::uint64_t velocityStream = 1U << 16;
constexpr std::uint64_t widthStream = 2U << 16;

std::uint8_t ToWord(double value, double scale, double offset)
{
  return static_cast<std::uint8_t>(std::clamp(std::lround(value * scale + offset), 2L, 255L));
}

// Strength of the echoes of a ray at the receiver, in dB, by slant range: Z over the square of the
// range, so that the weakest that can be seen is the same at all ranges.
class ReceivedPower
{
public:
  explicit ReceivedPower(const RayEcho& echo)
    : layout(echo.layout)
    , weakest(echo.options.sensitivity - 20.0 * std::log10(sensitivityRange))
    , power(echo.reflectivity)
  {
    for (int gate = 0; gate < layout.gates; ++gate)
    {
      double& value = power[static_cast<std::size_t>(gate)];
      if (std::isfinite(value))
      {
        value -= 20.0 * std::log10(std::max(layout.Range(gate), nearestRange));
      }
    }
  }

  /// The gate of the echo that a range lies in; it may lie off either end.
  int NearestGate(double range) const
  {
    return static_cast<int>(std::floor((range - layout.firstGate) / layout.gateSpacing + 0.5));
  }

  /// Interpolated; nothing where the echo is too weak to be seen.
  double At(double range) const
  {
    const double gate = (range - layout.firstGate) / layout.gateSpacing;
    const int nearest = this->NearestGate(range);
    if (nearest < 0 || nearest >= layout.gates)
    {
      return nothing;
    }
    double here = power[static_cast<std::size_t>(nearest)];
    if (!std::isfinite(here))
    {
      return nothing; // whatever the neighbour holds: there is nothing to interpolate from
    }
    const int other = gate < nearest ? nearest - 1 : nearest + 1;
    if (other >= 0 && other < layout.gates)
    {
      const double there = power[static_cast<std::size_t>(other)];
      here += std::isfinite(there) ? std::abs(gate - nearest) * (there - here) : 0.0;
    }
    return here < weakest ? nothing : here;
  }

  /// The strongest of the echoes that reach the receiver together with the one at `range`.
  double StrongestOverlay(double range, double unambiguousRange) const
  {
    const double farthest = layout.Range(layout.gates - 1);
    double strongest = nothing;
    const double trip = std::floor(range / unambiguousRange);
    for (double other = range - trip * unambiguousRange; other <= farthest;
         other += unambiguousRange)
    {
      if (std::abs(other - range) > 1.0)
      {
        strongest = std::max(strongest, this->At(other));
      }
    }
    return strongest;
  }

private:
  const GateLayout& layout;
  double weakest;
  std::vector<double> power;
};

// Spectrum width of an echo without shear, m/s: strong echo is turbulent; the square root of its
// reflectivity stands for that.
double OwnWidth(double reflectivity)
{
  constexpr double floor = 1.5;
  return floor + std::sqrt(std::max(reflectivity, 0.0)) / 2.0;
}

} // namespace

double SensitivityAt(double range, const SimulatorOptions& options)
{
  return options.sensitivity + 20.0 * std::log10(std::max(range, nearestRange) / sensitivityRange);
}

void WriteReflectivityWords(const RayEcho& echo, int gates, std::uint8_t* words)
{
  for (int gate = 0; gate < gates; ++gate)
  {
    const auto index = static_cast<std::size_t>(gate);
    words[index] = belowThreshold;
    if (!std::isfinite(echo.reflectivity[index]))
    {
      continue;
    }
    const double measured = echo.reflectivity[index] +
                            echo.options.noise * Normal(echo.noiseKey, reflectivityStream + index);
    if (measured >= SensitivityAt(echo.layout.Range(gate), echo.options))
    {
      words[index] = ToWord(measured, ReflectivityScale, ReflectivityOffset);
    }
  }
}

void WriteDopplerWords(const RayEcho& echo, const GateLayout& doppler, double unambiguousRange,
  const std::vector<EchoSpread>& spreads, VelocitySampler& wind, std::uint8_t* velocityWords,
  std::uint8_t* widthWords, std::vector<float>* truth)
{
  const double nyquist = NyquistVelocity(unambiguousRange / 1000.0);
  const ReceivedPower received(echo);
  for (int gate = 0; gate < doppler.gates; ++gate)
  {
    const auto index = static_cast<std::size_t>(gate);
    velocityWords[index] = widthWords[index] = belowThreshold;
    const double range = doppler.Range(gate);
    const double power = range > 0.0 ? received.At(range) : nothing;
    if (power == nothing)
    {
      continue;
    }
    if (power < received.StrongestOverlay(range, unambiguousRange) + overlayThreshold)
    {
      velocityWords[index] = widthWords[index] = rangeFolded;
      continue;
    }
    const auto echoGate = static_cast<std::size_t>(received.NearestGate(range));
    const BeamVelocity air = wind.Sample(range, spreads[echoGate]);
    const double velocity =
      air.mean + velocityNoise * Normal(echo.noiseKey, velocityStream + index);
    const double own = OwnWidth(power + 20.0 * std::log10(range));
    const double width =
      std::hypot(own, air.deviation) + widthNoise * Normal(echo.noiseKey, widthStream + index);
    velocityWords[index] = ToWord(FoldVelocity(velocity, nyquist), DopplerScale, DopplerOffset);
    widthWords[index] = ToWord(std::max(width, 0.0), DopplerScale, DopplerOffset);
    if (truth)
    {
      (*truth)[index] = static_cast<float>(air.mean);
    }
  }
}

} // namespace nexrad

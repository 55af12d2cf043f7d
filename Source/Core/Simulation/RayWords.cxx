// SPDX-License-Identifier: BSD-3-Clause
#include "Simulation/RayWords.h"

#include "Simulation/CounterNoise.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace nexrad
{

namespace
{

constexpr double degree = 3.14159265358979323846 / 180.0;
constexpr double nothing = -std::numeric_limits<double>::infinity();
constexpr double overlayThreshold = 5.0; // dB by which one of two overlaid echoes must be stronger
constexpr double velocityNoise = 1.2;    // m/s, standard deviation
constexpr double widthNoise = 0.9;       // m/s, standard deviation

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

double ReflectivityAt(const RayEcho& echo, double range)
{
  const double gate = (range - echo.layout.firstGate) / echo.layout.gateSpacing;
  const long nearest = std::lround(gate);
  if (nearest < 0 || nearest >= echo.layout.gates)
  {
    return nothing;
  }
  const double here = echo.reflectivity[static_cast<std::size_t>(nearest)];
  const long other = gate < static_cast<double>(nearest) ? nearest - 1 : nearest + 1;
  if (other < 0 || other >= echo.layout.gates)
  {
    return here;
  }
  const double there = echo.reflectivity[static_cast<std::size_t>(other)];
  const double share = std::abs(gate - static_cast<double>(nearest));
  return std::isfinite(there) ? here + share * (there - here) : here;
}

// Strength of an echo at the receiver, dB; nothing where it is too weak to be seen.
double ReceivedPower(const RayEcho& echo, double range)
{
  const double reflectivity = ReflectivityAt(echo, range);
  return reflectivity < SensitivityAt(range, echo.options)
           ? nothing
           : reflectivity - 20.0 * std::log10(range);
}

// The strongest of the echoes that reach the receiver together with the one at `range`.
double StrongestOverlay(const RayEcho& echo, double range, double unambiguousRange)
{
  const double farthest = echo.layout.Range(echo.layout.gates - 1);
  double strongest = nothing;
  double other = std::fmod(range, unambiguousRange);
  for (; other <= farthest; other += unambiguousRange)
  {
    if (std::abs(other - range) > 1.0 && other > 0.0)
    {
      strongest = std::max(strongest, ReceivedPower(echo, other));
    }
  }
  return strongest;
}

double Fold(double velocity, double nyquist)
{
  return std::remainder(velocity, 2.0 * nyquist);
}

} // namespace

double SensitivityAt(double range, const SimulatorOptions& options)
{
  constexpr double reference = 50'000.0; // m
  return options.sensitivity + 20.0 * std::log10(std::max(range, 250.0) / reference);
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
  const RayDirection& direction, const BeamSampler& beam, const StormSnapshot& snapshot,
  std::uint8_t* velocityWords, std::uint8_t* widthWords)
{
  const double level = std::cos(direction.elevation * degree);
  const double east = level * std::sin(direction.azimuth * degree);
  const double north = level * std::cos(direction.azimuth * degree);
  const double nyquist = NyquistVelocity(unambiguousRange / 1000.0);
  for (int gate = 0; gate < doppler.gates; ++gate)
  {
    const auto index = static_cast<std::size_t>(gate);
    velocityWords[index] = widthWords[index] = belowThreshold;
    const double range = doppler.Range(gate);
    const double power = range > 0.0 ? ReceivedPower(echo, range) : nothing;
    if (power == nothing)
    {
      continue;
    }
    if (power < StrongestOverlay(echo, range, unambiguousRange) + overlayThreshold)
    {
      velocityWords[index] = widthWords[index] = rangeFolded;
      continue;
    }
    const WindVector wind = snapshot.Wind(beam.Centre(range));
    const double velocity = east * wind.east + north * wind.north +
                            velocityNoise * Normal(echo.noiseKey, velocityStream + index);
    // Strong echo is turbulent; the square root of the reflectivity's excess stands for that.
    const double turbulence = std::sqrt(std::max(ReflectivityAt(echo, range), 0.0)) / 2.0;
    const double width = 1.5 + turbulence + widthNoise * Normal(echo.noiseKey, widthStream + index);
    velocityWords[index] = ToWord(Fold(velocity, nyquist), DopplerScale, DopplerOffset);
    widthWords[index] = ToWord(std::max(width, 0.0), DopplerScale, DopplerOffset);
  }
}

} // namespace nexrad

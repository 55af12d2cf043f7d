// SPDX-License-Identifier: BSD-3-Clause
#include "nexrad/Simulation/RayWords.h"

#include "nexrad/Simulation/AddedEcho.h"
#include "nexrad/Simulation/CounterNoise.h"
#include "nexrad/Simulation/GateLayout.h"
#include "nexrad/Simulation/ScanStrategy.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace nexrad
{

namespace
{

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

std::uint8_t ToWord(double value, const WordCode& code)
{
  const double raw = value * static_cast<double>(code.scale) + static_cast<double>(code.offset);
  return static_cast<std::uint8_t>(std::clamp(std::lround(raw), 2L, 255L));
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
      return NoReflectivity;
    }
    double here = power[static_cast<std::size_t>(nearest)];
    if (!std::isfinite(here))
    {
      return NoReflectivity; // whatever the neighbour holds: there is nothing to interpolate from
    }
    const int other = gate < nearest ? nearest - 1 : nearest + 1;
    if (other >= 0 && other < layout.gates)
    {
      const double there = power[static_cast<std::size_t>(other)];
      here += std::isfinite(there) ? std::abs(gate - nearest) * (there - here) : 0.0;
    }
    return here < weakest ? NoReflectivity : here;
  }

  /// The strongest of the echoes that reach the receiver together with the one at `range`.
  double StrongestOverlay(double range, double unambiguousRange) const
  {
    const double farthest = layout.Range(layout.gates - 1);
    double strongest = NoReflectivity;
    const double trip = std::floor(range / unambiguousRange);
    double other = range - trip * unambiguousRange;
    while (other <= farthest)
    {
      if (std::abs(other - range) > 1.0)
      {
        strongest = std::max(strongest, this->At(other));
      }
      other += unambiguousRange;
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

// How the echo of a gate moves.
struct GateMotion
{
  double mean;     // m/s, before noise; NaN: the echo has no velocity
  double velocity; // m/s, with noise, not folded
  double width;    // m/s, with noise
};

struct GateView
{
  double range;        // m
  double reflectivity; // dBZ
  double nyquist;      // m/s
};

// Ground stands still. Nearly: the antenna turns on while it measures.
GateMotion MoveGround(const RayEcho& echo, std::size_t gate)
{
  return {0.0, 0.35 * Normal(echo.noiseKey, velocityStream + gate),
    0.6 + 0.25 * Normal(echo.noiseKey, widthStream + gate)};
}

// Noise has any velocity.
GateMotion MoveNoise(const RayEcho& echo, std::size_t gate, double nyquist)
{
  return {std::numeric_limits<double>::quiet_NaN(),
    nyquist * (2.0 * Uniform(echo.noiseKey, velocityStream + gate) - 1.0),
    2.0 + 8.0 * Uniform(echo.noiseKey, widthStream + gate)};
}

GateMotion MoveAir(const RayEcho& echo, std::size_t echoGate, std::size_t gate,
  const GateView& view, VelocitySampler& wind)
{
  const BeamVelocity air = wind.Sample(view.range, echo.spreads[echoGate]);
  // The weak clear-air return of every day drifts with the wind; a bloom flies.
  const bool flies = echo.kinds[echoGate] == EchoKind::Biological &&
                     echo.options.notWeather.count(EchoKind::Biological) > 0;
  const double own = OwnWidth(view.reflectivity);
  const double mean = air.mean + (flies ? wind.Along(AddedEcho::OwnFlight()) : 0.0);
  return {mean, mean + velocityNoise * Normal(echo.noiseKey, velocityStream + gate),
    std::sqrt(own * own + air.deviation * air.deviation) +
      widthNoise * Normal(echo.noiseKey, widthStream + gate)};
}

GateMotion Move(const RayEcho& echo, std::size_t echoGate, std::size_t gate, const GateView& view,
  VelocitySampler& wind)
{
  switch (echo.kinds[echoGate])
  {
  case EchoKind::Clutter:
  case EchoKind::AnomalousPropagation:
    return MoveGround(echo, gate);
  case EchoKind::Sun:
  case EchoKind::Interference:
  case EchoKind::Speckle:
    return MoveNoise(echo, gate, view.nyquist);
  default:
    return MoveAir(echo, echoGate, gate, view, wind);
  }
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
      words[index] = ToWord(measured + echo.options.bias, ReflectivityCode);
    }
  }
}

void WriteDopplerWords(const RayEcho& echo, const GateLayout& doppler, double unambiguousRange,
  VelocitySampler& wind, const DopplerWords& words)
{
  const double nyquist = NyquistVelocity(unambiguousRange / 1000.0);
  const ReceivedPower received(echo);
  for (int gate = 0; gate < doppler.gates; ++gate)
  {
    const auto index = static_cast<std::size_t>(gate);
    words.velocity[index] = words.width[index] = belowThreshold;
    const double range = doppler.Range(gate);
    const double power = range > 0.0 ? received.At(range) : NoReflectivity;
    if (power == NoReflectivity)
    {
      continue;
    }
    const auto echoGate = static_cast<std::size_t>(received.NearestGate(range));
    if (words.truth)
    {
      words.truth->velocityKinds[index] = echo.kinds[echoGate];
    }
    if (power < received.StrongestOverlay(range, unambiguousRange) + overlayThreshold)
    {
      words.velocity[index] = words.width[index] = rangeFolded;
      continue;
    }
    const GateMotion motion =
      Move(echo, echoGate, index, {range, power + 20.0 * std::log10(range), nyquist}, wind);
    words.velocity[index] = ToWord(FoldVelocity(motion.velocity, nyquist), DopplerCode);
    words.width[index] = ToWord(std::max(motion.width, 0.0), DopplerCode);
    if (words.truth)
    {
      words.truth->velocity[index] = static_cast<float>(motion.mean);
    }
  }
}

void WritePolarimetricWords(const std::vector<PolarimetricGate>& measured,
  const std::uint8_t* reflectivityWords, int gates, std::uint8_t* words)
{
  const auto count = static_cast<std::size_t>(gates);
  std::uint8_t* phases = words + count;
  std::uint8_t* correlations = phases + 2 * count;
  std::fill(words, correlations + count, belowThreshold);
  for (std::size_t gate = 0; gate < count; ++gate)
  {
    if (reflectivityWords[gate] != belowThreshold)
    {
      constexpr long mostPhase = 1022; // 359.6 degrees, the most in real files
      const long phase = std::clamp(
        std::lround(measured[gate].phase * PhaseCode.scale + PhaseCode.offset), 2L, mostPhase);
      words[gate] = ToWord(measured[gate].differentialReflectivity, DifferentialCode);
      phases[2 * gate] = static_cast<std::uint8_t>(phase >> 8);
      phases[2 * gate + 1] = static_cast<std::uint8_t>(phase & 0xff);
      correlations[gate] = ToWord(measured[gate].correlation, CorrelationCode);
    }
  }
}

namespace
{

void SetRow(
  MomentRow& row, const GateLayout& layout, const std::uint8_t* words, const WordCode& code)
{
  if (layout.gates > 0)
  {
    row.words = words;
    row.gates = static_cast<std::uint16_t>(layout.gates);
    row.firstGate = layout.firstGate;
    row.gateSpacing = layout.gateSpacing;
    row.scale = code.scale;
    row.offset = code.offset;
  }
}

} // namespace

RayBlocks::RayBlocks(const CutLayout& layout, int polarimetricCount, std::uint8_t* words)
  : reflectivityGates(layout.reflectivity)
  , dopplerGates(layout.doppler)
  , polarimetricGates(layout.reflectivity)
  , reflectivity(words)
  , velocity(words + reflectivityGates.gates)
  , width(velocity + dopplerGates.gates)
  , polarimetric(width + dopplerGates.gates)
{
  polarimetricGates.gates = polarimetricCount;
}

std::size_t RayBlocks::Bytes(const CutLayout& layout, int polarimetricCount)
{
  return static_cast<std::size_t>(layout.reflectivity.gates) +
         2 * static_cast<std::size_t>(layout.doppler.gates) +
         4 * static_cast<std::size_t>(polarimetricCount);
}

void RayBlocks::Describe(Ray& ray) const
{
  const int count = polarimetricGates.gates;
  SetRow(ray.Row(MomentName::REF), reflectivityGates, reflectivity, ReflectivityCode);
  SetRow(ray.Row(MomentName::VEL), dopplerGates, velocity, DopplerCode);
  SetRow(ray.Row(MomentName::SW), dopplerGates, width, DopplerCode);
  SetRow(ray.Row(MomentName::ZDR), polarimetricGates, polarimetric, DifferentialCode);
  SetRow(ray.Row(MomentName::PHI), polarimetricGates, polarimetric + count, PhaseCode);
  SetRow(ray.Row(MomentName::RHO), polarimetricGates, polarimetric + 3 * count, CorrelationCode);
  if (count > 0)
  {
    ray.Row(MomentName::PHI).wordBits = 16;
  }
}

void RayBlocks::FillWithPattern() const
{
  constexpr std::uint8_t strength = 136;  // 35 dBZ
  constexpr std::uint8_t speed = 149;     // 10 m/s
  constexpr std::uint8_t spread = 137;    // 4 m/s
  constexpr std::uint8_t agreement = 144; // 1 dB of Z_DR, and 0.68 of correlation
  constexpr std::uint8_t phaseBytes = 1;  // twice: the word 257, 89.9°
  const int count = polarimetricGates.gates;
  std::fill(reflectivity, velocity, strength);
  std::fill(velocity, width, speed);
  std::fill(width, polarimetric, spread);
  std::fill(polarimetric, polarimetric + count, agreement);
  std::fill(polarimetric + count, polarimetric + 3 * count, phaseBytes);
  std::fill(polarimetric + 3 * count, polarimetric + 4 * count, agreement);
}

} // namespace nexrad

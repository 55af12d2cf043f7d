// SPDX-License-Identifier: BSD-3-Clause
#include "nexrad/Simulation/RadarSimulator.h"

#include "nexrad/Simulation/AddedEcho.h"
#include "nexrad/Simulation/BeamSampler.h"
#include "nexrad/Simulation/CounterNoise.h"
#include "nexrad/Simulation/DualPolarisation.h"
#include "nexrad/Simulation/ScanStrategy.h"
#include "nexrad/System/Error.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

namespace nexrad
{

namespace
{

constexpr double cutGap = 0.8;            // s between two cuts
constexpr double volumeGap = 5.0;         // s between two volumes
constexpr double azimuthJitter = 0.03;    // degrees, half the span
constexpr double elevationJitter = 0.02;  // degrees, half the span
constexpr double elevationSettle = 0.12;  // degrees that a cut begins too low or too high
constexpr double raysToSettle = 15.0;     // rays over which that dies away
constexpr double maximumElevation = 0.45; // degrees off the cut, within BeamSampler's margin

const std::vector<ScanCut>& RequireStrategy(int pattern)
{
  const std::vector<ScanCut>* strategy = FindScanStrategy(pattern);
  if (!strategy)
  {
    std::string known;
    for (const int number : KnownCoveragePatterns())
    {
      known += (known.empty() ? "" : ", ") + std::to_string(number);
    }
    throw Error(
      "coverage pattern " + std::to_string(pattern) + " cannot be simulated; known are " + known);
  }
  return *strategy;
}

void RequirePositive(double value, const char* name)
{
  if (!(value > 0.0))
  {
    throw Error(
      "simulator: " + std::string(name) + " is " + std::to_string(value) + "; it must be above 0");
  }
}

double CutDuration(const ScanCut& cut, const CutLayout& layout)
{
  return layout.rays * layout.raySpacing / cut.cut.azimuthRate;
}

Time Later(Time start, double seconds)
{
  return start + Duration(std::llround(seconds * 1000.0));
}

double WrapAzimuth(double azimuth)
{
  return azimuth - 360.0 * std::floor(azimuth / 360.0);
}

// What one ray saw, from which its words are made. The vectors are of the gates of `layout`.
struct RayEcho
{
  const SimulatorOptions& options;
  const GateLayout& layout;
  const std::vector<double>& reflectivity; // dBZ, without noise; -infinity: nothing
  const std::vector<EchoSpread>& spreads;  // of the storms
  const std::vector<EchoKind>& kinds;
  std::uint64_t noiseKey; // CounterNoise
};

// How the simulator's words stand for values: value = (word − offset)/scale, in dBZ, m/s, dB,
// degrees and without dimension: those of real files. Words of PHI have 16 bits, others 8.
struct WordCode
{
  float scale;
  float offset;
};
constexpr WordCode ReflectivityCode{2.0F, 66.0F};
constexpr WordCode DopplerCode{2.0F, 129.0F};
constexpr WordCode DifferentialCode{16.0F, 128.0F};
constexpr WordCode PhaseCode{2.8361F, 2.0F};
constexpr WordCode CorrelationCode{300.0F, -60.5F};

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

// Where the words of a ray's moments stand, one after another: those of REF, VEL, SW, then ZDR,
// PHI (two bytes each) and RHO.
struct RayBlocks
{
  // `words` holds Bytes of the same layout.
  RayBlocks(const CutLayout& layout, int polarimetricCount, std::uint8_t* words)
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

  static std::size_t Bytes(const CutLayout& layout, int polarimetricCount)
  {
    return static_cast<std::size_t>(layout.reflectivity.gates) +
           2 * static_cast<std::size_t>(layout.doppler.gates) +
           4 * static_cast<std::size_t>(polarimetricCount);
  }

  // Sets the rows of a ray that have gates: they point to the words.
  void Describe(Ray& ray) const
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

  // Puts one value into all gates of a moment, as a receiver's test pattern does.
  void FillWithPattern() const
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

  GateLayout reflectivityGates;
  GateLayout dopplerGates;
  GateLayout polarimetricGates;
  std::uint8_t* reflectivity;
  std::uint8_t* velocity;
  std::uint8_t* width;
  std::uint8_t* polarimetric;
};

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

  // The gate of the echo that a range lies in; it may lie off either end.
  int NearestGate(double range) const
  {
    return static_cast<int>(std::floor((range - layout.firstGate) / layout.gateSpacing + 0.5));
  }

  // Interpolated; nothing where the echo is too weak to be seen.
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

  // The strongest of the echoes that reach the receiver together with the one at `range`.
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

// Words of REF, whose gates begin and step as the echo's: with noise and the radar's bias, 0 below
// the sensitivity.
void WriteReflectivityWords(const RayEcho& echo, const RayBlocks& words)
{
  for (int gate = 0; gate < words.reflectivityGates.gates; ++gate)
  {
    const auto index = static_cast<std::size_t>(gate);
    words.reflectivity[index] = belowThreshold;
    if (!std::isfinite(echo.reflectivity[index]))
    {
      continue;
    }
    const double measured = echo.reflectivity[index] +
                            echo.options.noise * Normal(echo.noiseKey, reflectivityStream + index);
    if (measured >= SensitivityAt(echo.layout.Range(gate), echo.options))
    {
      words.reflectivity[index] = ToWord(measured + echo.options.bias, ReflectivityCode);
    }
  }
}

// Words of VEL and SW: 0 below the sensitivity, 1 where an echo of another pulse overlies; and what
// is true of them, unless `truth` is nullptr.
void WriteDopplerWords(const RayEcho& echo, double unambiguousRange, VelocitySampler& wind,
  const RayBlocks& words, RayTruth* truth)
{
  const GateLayout& doppler = words.dopplerGates;
  const double nyquist = NyquistVelocity(unambiguousRange / 1000.0);
  const ReceivedPower received(echo);
  if (truth)
  {
    const auto gates = static_cast<std::size_t>(doppler.gates);
    truth->velocity.assign(gates, std::numeric_limits<float>::quiet_NaN());
    truth->velocityKinds.assign(gates, EchoKind::None);
  }
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
    if (truth)
    {
      truth->velocityKinds[index] = echo.kinds[echoGate];
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
    if (truth)
    {
      truth->velocity[index] = static_cast<float>(motion.mean);
    }
  }
}

// Words of ZDR, PHI and RHO for the first gates of the echo: 0 where the word of REF is.
void WritePolarimetricWords(const std::vector<PolarimetricGate>& measured, const RayBlocks& words)
{
  const auto count = static_cast<std::size_t>(words.polarimetricGates.gates);
  std::uint8_t* differentials = words.polarimetric;
  std::uint8_t* phases = differentials + count;
  std::uint8_t* correlations = phases + 2 * count;
  std::fill(differentials, correlations + count, belowThreshold);
  for (std::size_t gate = 0; gate < count; ++gate)
  {
    if (words.reflectivity[gate] != belowThreshold)
    {
      constexpr long mostPhase = 1022; // 359.6 degrees, the most in real files
      const long phase = std::clamp(
        std::lround(measured[gate].phase * PhaseCode.scale + PhaseCode.offset), 2L, mostPhase);
      differentials[gate] = ToWord(measured[gate].differentialReflectivity, DifferentialCode);
      phases[2 * gate] = static_cast<std::uint8_t>(phase >> 8);
      phases[2 * gate + 1] = static_cast<std::uint8_t>(phase & 0xff);
      correlations[gate] = ToWord(measured[gate].correlation, CorrelationCode);
    }
  }
}

class VolumeScan
{
public:
  // `radarKey` is the site's, `volumeKey` that and the start's.
  VolumeScan(const StormField& stormField, const Position& antenna, const SimulatorOptions& choices,
    std::uint64_t radarKey, std::uint64_t volumeKey)
    : field(stormField)
    , position(antenna)
    , options(choices)
    , key(volumeKey)
    , added(choices.notWeather, radarKey, choices.beamWidth)
    , azimuth(360.0 * Uniform(volumeKey, 0))
  {
  }

  // The next cut, from `start` on. `truth`, where given, takes what is true of its gates.
  Sweep Scan(
    const ScanCut& cut, int number, Time start, RadarVolume& volume, std::vector<RayTruth>* truth)
  {
    const CutLayout layout = LayOut(cut, options.superResolution);
    BeamSampler beam(position, cut.cut.elevation, layout.echo.Range(layout.echo.gates),
      {options.effectiveRadiusFactor, options.beamWidth});
    const std::size_t rayBytes = RayBlocks::Bytes(layout, PolarimetricGates(cut, layout));
    const auto words =
      std::make_shared<std::vector<std::uint8_t>>(rayBytes * static_cast<std::size_t>(layout.rays));
    const std::uint64_t cutKey = Mix(key, static_cast<std::uint64_t>(number));

    Sweep sweep;
    sweep.elevationNumber = number;
    sweep.waveform = cut.cut.waveform;
    for (int index = 0; index < layout.rays; ++index)
    {
      const auto ordinal = static_cast<std::size_t>(index);
      const RayPlace place{number, index, layout.rays, Mix(cutKey, ordinal)};
      Ray ray = this->Aim(cut, layout, place, start);
      this->Measure(ray, cut, layout, beam,
        {place, words->data() + ordinal * rayBytes, truth ? &truth->emplace_back() : nullptr});
      sweep.rays.push_back(ray);
    }
    volume.buffers.push_back(words);
    azimuth = WrapAzimuth(azimuth + layout.rays * layout.raySpacing + cutGap * cut.cut.azimuthRate);
    return sweep;
  }

private:
  // Which ray is measured, and where its words and its truth go.
  struct RayTask
  {
    RayPlace place;
    std::uint8_t* words;
    RayTruth* truth; // nullptr: nobody asks
  };

  // Where the antenna points, and when, in the middle of a ray.
  Ray Aim(const ScanCut& cut, const CutLayout& layout, const RayPlace& place, Time start) const
  {
    const double turned = (place.index + 0.5) * layout.raySpacing;
    const double jitter =
      azimuthJitter * layout.raySpacing * (2.0 * Uniform(place.key, 1U << 20) - 1.0);
    const double settle =
      elevationSettle * (2.0 * Uniform(key, static_cast<std::uint64_t>(place.cut)) - 1.0);
    const double wobble = elevationJitter * (2.0 * Uniform(place.key, 2U << 20) - 1.0);
    Ray ray;
    ray.time = Later(start, turned / cut.cut.azimuthRate);
    ray.azimuth = static_cast<float>(WrapAzimuth(azimuth + turned + jitter));
    ray.elevation = static_cast<float>(
      cut.cut.elevation + std::clamp(settle * std::exp(-place.index / raysToSettle) + wobble,
                            -maximumElevation, maximumElevation));
    ray.elevationNumber = static_cast<std::uint8_t>(place.cut);
    ray.unambiguousRange = static_cast<float>(cut.unambiguousRange * 1000.0);
    // Message 1 gives no Nyquist velocity in a surveillance cut.
    const bool hasNyquist = layout.doppler.gates > 0 || options.superResolution;
    ray.nyquist = hasNyquist ? static_cast<float>(NyquistVelocity(cut.unambiguousRange)) : 0.0F;
    return ray;
  }

  void Measure(
    Ray& ray, const ScanCut& cut, const CutLayout& layout, BeamSampler& beam, const RayTask& task)
  {
    const StormSnapshot snapshot = field.At(ray.time);
    beam.Point(ray.azimuth, ray.elevation);
    beam.Sample(snapshot, layout.echo, reflectivity);
    this->Classify(beam, layout.echo);
    if (added.Any())
    {
      added.AddTo(beam.Trace(), task.place, layout.echo, reflectivity, kinds);
    }
    const RayEcho echo{options, layout.echo, reflectivity, beam.Spreads(), kinds, task.place.key};
    const RayBlocks words(layout, this->PolarimetricGates(cut, layout), task.words);
    WriteReflectivityWords(echo, words);
    VelocitySampler wind(beam.Trace(), snapshot);
    WriteDopplerWords(echo, cut.unambiguousRange * 1000.0, wind, words, task.truth);
    if (words.polarimetricGates.gates > 0)
    {
      WritePolarimetricWords(
        MeasurePolarisation(beam.Trace(), layout.echo, reflectivity, kinds, task.place.key), words);
    }
    if (added.IsTestPattern(task.place))
    {
      words.FillWithPattern();
    }
    words.Describe(ray);
    if (task.truth)
    {
      this->NoteKinds(*task.truth, ray, task.place);
    }
  }

  // Storms, but for the weak return of clear air near the ground.
  void Classify(const BeamSampler& beam, const GateLayout& layout)
  {
    kinds.assign(reflectivity.size(), EchoKind::None);
    for (std::size_t gate = 0; gate < kinds.size(); ++gate)
    {
      if (std::isfinite(reflectivity[gate]))
      {
        const bool isClear = !beam.Spreads()[gate].bySide ||
                             (reflectivity[gate] <= StormSnapshot::ClearAirMaximum() &&
                               beam.Trace().Centre(layout.Range(static_cast<int>(gate))).z <
                                 StormSnapshot::ClearAirTop());
        kinds[gate] = isClear ? EchoKind::Biological : EchoKind::Weather;
      }
    }
  }

  // Real files have the moments of two polarisations in all cuts but the Doppler half of a split
  // one, for 300 km.
  int PolarimetricGates(const ScanCut& cut, const CutLayout& layout) const
  {
    constexpr int most = 1'192;
    const bool has = options.dualPolarisation && cut.cut.waveform != Waveform::ContiguousDoppler;
    return has ? std::min(layout.reflectivity.gates, most) : 0;
  }

  void NoteKinds(RayTruth& truth, const Ray& ray, const RayPlace& place) const
  {
    const MomentRow& row = ray.Row(MomentName::REF);
    truth.reflectivityKinds.assign(row.gates, EchoKind::None);
    for (std::size_t gate = 0; gate < row.gates; ++gate)
    {
      if (row.State(gate) == GateState::Valid)
      {
        truth.reflectivityKinds[gate] = kinds[gate];
      }
    }
    if (added.IsTestPattern(place))
    {
      const auto fill = [](auto& values, auto value)
      { std::fill(values.begin(), values.end(), value); };
      fill(truth.reflectivityKinds, EchoKind::TestPattern);
      fill(truth.velocityKinds, EchoKind::TestPattern);
      fill(truth.velocity, std::numeric_limits<float>::quiet_NaN());
    }
  }

  const StormField& field;
  const Position& position;
  const SimulatorOptions& options;
  std::uint64_t key;
  AddedEcho added;
  double azimuth; // degrees, where the next cut begins
  // Of the ray in hand, kept to save their memory.
  std::vector<double> reflectivity;
  std::vector<EchoKind> kinds;
};

// Radial status: 3 and 4 at the ends of the volume, 0 and 2 at the ends of the other cuts.
void MarkEnds(std::vector<Sweep>& sweeps)
{
  for (Sweep& sweep : sweeps)
  {
    sweep.rays.front().radialStatus = RadialStatus::StartOfCut;
    sweep.rays.back().radialStatus = RadialStatus::EndOfCut;
  }
  sweeps.front().rays.front().radialStatus = RadialStatus::StartOfVolume;
  sweeps.back().rays.back().radialStatus = RadialStatus::EndOfVolume;
}

// The pattern as message 5 describes it: without super-resolution where it is not scanned so.
CoveragePattern PatternAsScanned(
  int number, const std::vector<ScanCut>& strategy, const SimulatorOptions& options)
{
  CoveragePattern pattern;
  pattern.number = number;
  for (const ScanCut& scanned : strategy)
  {
    CoverageCut& cut = pattern.cuts.emplace_back(scanned.cut);
    cut.superResolution = cut.superResolution && options.superResolution;
  }
  return pattern;
}

} // namespace

double SensitivityAt(double range, const SimulatorOptions& options)
{
  return options.sensitivity + 20.0 * std::log10(std::max(range, nearestRange) / sensitivityRange);
}

RadarVolume ScanVolume(const StormField& field, const Site& site, int coveragePattern, Time start,
  const SimulatorOptions& options, ScanTruth* truth)
{
  const std::vector<ScanCut>& strategy = RequireStrategy(coveragePattern);
  if (!site.position)
  {
    throw Error("simulator: site '" + site.name + "' has no position; give one, or a known site");
  }
  RequirePositive(options.effectiveRadiusFactor, "the effective radius factor");
  RequirePositive(options.beamWidth, "the beam width");
  if (options.dualPolarisation && !options.superResolution)
  {
    throw Error("simulator: message 1 has no dual polarisation; ask for message 31");
  }

  RadarVolume volume;
  volume.site = site;
  volume.coveragePatternNumber = coveragePattern;
  volume.coveragePattern = PatternAsScanned(coveragePattern, strategy, options);
  volume.messageType = options.superResolution ? 31 : 1;
  volume.headerTime = start;
  volume.complete = true;
  volume.synthetic = true;
  const std::uint64_t radarKey = Mix(Mix(options.seed), KeyOf(site.name));
  const auto startCount = static_cast<std::uint64_t>(start.time_since_epoch().count());
  VolumeScan scan(field, *site.position, options, radarKey, Mix(radarKey, startCount));
  if (truth)
  {
    truth->sweeps.clear();
  }
  double elapsed = 0.0;
  int number = 0;
  for (const ScanCut& cut : strategy)
  {
    std::vector<RayTruth>* rays = truth ? &truth->sweeps.emplace_back() : nullptr;
    volume.sweeps.push_back(scan.Scan(cut, ++number, Later(start, elapsed), volume, rays));
    elapsed += CutDuration(cut, LayOut(cut, options.superResolution)) + cutGap;
  }
  MarkEnds(volume.sweeps);
  return volume;
}

Duration VolumePeriod(int coveragePattern)
{
  double seconds = volumeGap;
  for (const ScanCut& cut : RequireStrategy(coveragePattern))
  {
    seconds += CutDuration(cut, LayOut(cut, false)) + cutGap;
  }
  return Duration(std::llround(seconds * 1000.0));
}

} // namespace nexrad

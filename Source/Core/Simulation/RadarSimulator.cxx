// SPDX-License-Identifier: BSD-3-Clause
#include "nexrad/Simulation/RadarSimulator.h"

#include "nexrad/Simulation/AddedEcho.h"
#include "nexrad/Simulation/BeamSampler.h"
#include "nexrad/Simulation/CounterNoise.h"
#include "nexrad/Simulation/RayWords.h"
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

std::uint64_t KeyOf(const std::string& name)
{
  std::uint64_t key = 0;
  for (const char letter : name)
  {
    key = Mix(key, static_cast<unsigned char>(letter));
  }
  return key;
}

Time Later(Time start, double seconds)
{
  return start + Duration(std::llround(seconds * 1000.0));
}

double WrapAzimuth(double azimuth)
{
  return azimuth - 360.0 * std::floor(azimuth / 360.0);
}

// Scans one volume, cut after cut.
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
    const ScanCut& cut, int number, Time start, RadarVolume& volume, std::vector<RayTruth>* truth);

private:
  const StormField& field;
  const Position& position;
  const SimulatorOptions& options;
  std::uint64_t key;
  AddedEcho added;
  double azimuth; // degrees, where the next cut begins

  // Which ray is measured, and where its words and its truth go.
  struct RayTask
  {
    RayPlace place;
    std::uint8_t* words;
    RayTruth* truth; // nullptr: nobody asks
  };

  Ray Aim(const ScanCut& cut, const CutLayout& layout, int number, int index, Time start) const;
  void Measure(
    Ray& ray, const ScanCut& cut, const CutLayout& layout, BeamSampler& beam, const RayTask& task);
  void Classify(const BeamSampler& beam, const GateLayout& layout);
  int PolarimetricGates(const ScanCut& cut, const CutLayout& layout) const;
  static void Prepare(RayTruth& truth, const CutLayout& layout);
  void NoteKinds(RayTruth& truth, const Ray& ray, const RayPlace& place) const;
  // Of the ray in hand, kept to save their memory.
  std::vector<double> reflectivity;
  std::vector<EchoKind> kinds;
};

// Where the antenna points, and when, in the middle of a ray.
Ray VolumeScan::Aim(
  const ScanCut& cut, const CutLayout& layout, int number, int index, Time start) const
{
  const std::uint64_t rayKey =
    Mix(Mix(key, static_cast<std::uint64_t>(number)), static_cast<std::uint64_t>(index));
  const double turned = (index + 0.5) * layout.raySpacing;
  const double jitter = azimuthJitter * layout.raySpacing * (2.0 * Uniform(rayKey, 1U << 20) - 1.0);
  const double settle =
    elevationSettle * (2.0 * Uniform(key, static_cast<std::uint64_t>(number)) - 1.0);
  const double wobble = elevationJitter * (2.0 * Uniform(rayKey, 2U << 20) - 1.0);
  Ray ray;
  ray.time = Later(start, turned / cut.cut.azimuthRate);
  ray.azimuth = static_cast<float>(WrapAzimuth(azimuth + turned + jitter));
  ray.elevation = static_cast<float>(
    cut.cut.elevation + std::clamp(settle * std::exp(-index / raysToSettle) + wobble,
                          -maximumElevation, maximumElevation));
  ray.elevationNumber = static_cast<std::uint8_t>(number);
  ray.unambiguousRange = static_cast<float>(cut.unambiguousRange * 1000.0);
  // Message 1 gives no Nyquist velocity in a surveillance cut.
  const bool hasNyquist = layout.doppler.gates > 0 || options.superResolution;
  ray.nyquist = hasNyquist ? static_cast<float>(NyquistVelocity(cut.unambiguousRange)) : 0.0F;
  return ray;
}

// Storms, but for the weak return of clear air near the ground.
void VolumeScan::Classify(const BeamSampler& beam, const GateLayout& layout)
{
  kinds.assign(reflectivity.size(), EchoKind::None);
  for (std::size_t gate = 0; gate < kinds.size(); ++gate)
  {
    if (std::isfinite(reflectivity[gate]))
    {
      const bool isClear =
        !beam.Spreads()[gate].bySide ||
        (reflectivity[gate] <= StormSnapshot::ClearAirMaximum() &&
          beam.Centre(layout.Range(static_cast<int>(gate))).z < StormSnapshot::ClearAirTop());
      kinds[gate] = isClear ? EchoKind::Biological : EchoKind::Weather;
    }
  }
}

// Real files have the moments of two polarisations in all cuts but the Doppler half of a split one,
// for 300 km.
int VolumeScan::PolarimetricGates(const ScanCut& cut, const CutLayout& layout) const
{
  constexpr int most = 1'192;
  const bool has = options.dualPolarisation && cut.cut.waveform != Waveform::ContiguousDoppler;
  return has ? std::min(layout.reflectivity.gates, most) : 0;
}

void VolumeScan::Measure(
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
  const int polarimetricGates = this->PolarimetricGates(cut, layout);
  const RayBlocks blocks(layout, polarimetricGates, task.words);
  WriteReflectivityWords(echo, layout.reflectivity.gates, blocks.reflectivity);
  if (task.truth)
  {
    Prepare(*task.truth, layout);
  }
  VelocitySampler wind(beam.Trace(), snapshot);
  WriteDopplerWords(echo, layout.doppler, cut.unambiguousRange * 1000.0, wind,
    {blocks.velocity, blocks.width, task.truth});
  if (polarimetricGates > 0)
  {
    WritePolarimetricWords(
      MeasurePolarisation(beam.Trace(), layout.echo, reflectivity, kinds, task.place.key),
      blocks.reflectivity, polarimetricGates, blocks.polarimetric);
  }
  if (added.IsTestPattern(task.place))
  {
    blocks.FillWithPattern();
  }
  blocks.Describe(ray);
  if (task.truth)
  {
    this->NoteKinds(*task.truth, ray, task.place);
  }
}

void VolumeScan::Prepare(RayTruth& truth, const CutLayout& layout)
{
  const auto gates = static_cast<std::size_t>(layout.doppler.gates);
  truth.velocity.assign(gates, std::numeric_limits<float>::quiet_NaN());
  truth.velocityKinds.assign(gates, EchoKind::None);
}

void VolumeScan::NoteKinds(RayTruth& truth, const Ray& ray, const RayPlace& place) const
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

Sweep VolumeScan::Scan(
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
    const auto place = static_cast<std::size_t>(index);
    Ray ray = this->Aim(cut, layout, number, index, start);
    this->Measure(ray, cut, layout, beam,
      {{number, index, layout.rays, Mix(cutKey, place)}, words->data() + place * rayBytes,
        truth ? &truth->emplace_back() : nullptr});
    sweep.rays.push_back(ray);
  }
  volume.buffers.push_back(words);
  azimuth = WrapAzimuth(azimuth + layout.rays * layout.raySpacing + cutGap * cut.cut.azimuthRate);
  return sweep;
}

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
CoveragePattern PatternAsScanned(int number, const SimulatorOptions& options)
{
  CoveragePattern pattern = *FindCoveragePattern(number);
  for (CoverageCut& cut : pattern.cuts)
  {
    cut.superResolution = cut.superResolution && options.superResolution;
  }
  return pattern;
}

} // namespace

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
  volume.coveragePattern = PatternAsScanned(coveragePattern, options);
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

double TrueRadialVelocity(const StormField& field, const Position& site, Time time, double azimuth,
  double elevation, double range, double gateSpacing, const SimulatorOptions& options)
{
  const auto first = static_cast<int>(std::lround(range));
  const auto spacing = static_cast<int>(std::lround(gateSpacing));
  BeamSampler beam(
    site, elevation, range + 2.0 * gateSpacing, {options.effectiveRadiusFactor, options.beamWidth});
  const StormSnapshot snapshot = field.At(time);
  std::vector<double> reflectivity;
  beam.Point(azimuth, elevation);
  beam.Sample(snapshot, {1, first, spacing}, reflectivity);
  return VelocitySampler(beam.Trace(), snapshot).Sample(range, beam.Spreads()[0]).mean;
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

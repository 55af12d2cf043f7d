// SPDX-License-Identifier: BSD-3-Clause
#include "Gridding/BeamVolume.h"

#include "Geometry/Angles.h"
#include "Gridding/SweepPairing.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace nexrad
{

namespace
{

constexpr std::size_t valueCodes = 65'000;

// A ray's place in the sweep and its azimuth, 0…360.
struct SortedRay
{
  double azimuth;
  std::size_t ray;
};

std::vector<SortedRay> SortRays(const PolarSweep& sweep)
{
  constexpr double sameAzimuth = 1e-3; // degrees
  std::vector<SortedRay> sorted;
  for (std::size_t i = 0; i < sweep.rays.size(); ++i)
  {
    const double turned = std::fmod(sweep.rays[i].azimuth, 360.0);
    sorted.push_back({turned < 0.0 ? turned + 360.0 : turned, i});
  }
  // Of two rays in one direction the later comes first, and stays.
  const auto before = [&sweep](const SortedRay& a, const SortedRay& b)
  {
    return a.azimuth != b.azimuth ? a.azimuth < b.azimuth
                                  : sweep.rays[a.ray].time > sweep.rays[b.ray].time;
  };
  std::sort(sorted.begin(), sorted.end(), before);
  const auto same = [](const SortedRay& a, const SortedRay& b)
  { return b.azimuth - a.azimuth < sameAzimuth; };
  sorted.erase(std::unique(sorted.begin(), sorted.end(), same), sorted.end());
  return sorted;
}

// Rays and what of them stands before the first and after the last.
std::vector<SortedRay> CloseTheCircle(const std::vector<SortedRay>& rays)
{
  std::vector<SortedRay> entries = {{rays.back().azimuth - 360.0, rays.back().ray}};
  entries.insert(entries.end(), rays.begin(), rays.end());
  entries.push_back({rays.front().azimuth + 360.0, rays.front().ray});
  return entries;
}

double MedianGap(const std::vector<SortedRay>& entries)
{
  std::vector<double> gaps;
  for (std::size_t i = 0; i + 1 < entries.size(); ++i)
  {
    gaps.push_back(entries[i + 1].azimuth - entries[i].azimuth);
  }
  const auto middle = gaps.begin() + static_cast<std::ptrdiff_t>(gaps.size() / 2);
  std::nth_element(gaps.begin(), middle, gaps.end());
  return *middle;
}

void SetDirections(
  const PolarSweep& source, const std::vector<SortedRay>& entries, double beamWidth, BeamSweep& to)
{
  // A sweep of one ray has no spacing of its own.
  const double spacing = std::max(beamWidth, std::min(MedianGap(entries), 2.0));
  const double widest = 1.5 * spacing;
  to.halfWidth = static_cast<float>(0.5 * spacing);
  for (std::size_t i = 0; i < entries.size(); ++i)
  {
    to.azimuths.push_back(static_cast<float>(entries[i].azimuth));
    const PolarRay& ray = source.rays[entries[i].ray];
    to.elevations.push_back(static_cast<float>(ray.elevation));
    const Duration since = ray.time - to.begin;
    to.times.push_back(static_cast<float>(since.count()) / 1000.0F);
    const double gap =
      i + 1 < entries.size() ? entries[i + 1].azimuth - entries[i].azimuth : 2.0 * widest;
    to.inverseGaps.push_back(gap <= widest ? static_cast<float>(1.0 / gap) : 0.0F);
  }
  std::uint32_t entry = 0;
  const int bins = static_cast<int>(360.0F * BeamSweep::BinsPerDegree);
  for (int bin = 0; bin < bins; ++bin)
  {
    const float start = static_cast<float>(bin) / BeamSweep::BinsPerDegree;
    while (to.azimuths[entry + 1U] <= start)
    {
      ++entry;
    }
    to.firstEntries.push_back(entry);
  }
}

void SetScale(const PolarSweep& source, BeamSweep& to)
{
  float smallest = std::numeric_limits<float>::max();
  float largest = std::numeric_limits<float>::lowest();
  for (std::size_t i = 0; i < source.values.size(); ++i)
  {
    if (source.states[i] == GateState::Valid)
    {
      smallest = std::min(smallest, source.values[i]);
      largest = std::max(largest, source.values[i]);
    }
  }
  if (smallest <= largest)
  {
    to.step = (largest - smallest) / static_cast<float>(valueCodes);
    to.base = smallest - to.step * static_cast<float>(BeamSweep::FirstValueCode);
  }
}

std::uint16_t CodeOf(GateState state)
{
  switch (state)
  {
  case GateState::BelowThreshold:
    return BeamSweep::NoEchoCode;
  case GateState::RangeFolded:
    return BeamSweep::RangeFoldedCode;
  default:
    return BeamSweep::NotSampledCode;
  }
}

void SetCodes(const PolarSweep& source, const std::vector<SortedRay>& entries, BeamSweep& to)
{
  SetScale(source, to);
  const float stepsPerUnit = to.step > 0.0F ? 1.0F / to.step : 0.0F;
  const float offset = static_cast<float>(BeamSweep::FirstValueCode) + 0.5F;
  const float smallest = to.base + static_cast<float>(BeamSweep::FirstValueCode) * to.step;
  to.codes.reserve(entries.size() * to.Stride());
  for (const SortedRay& entry : entries)
  {
    for (std::size_t gate = 0; gate < source.gates; ++gate)
    {
      const std::size_t index = source.Index(entry.ray, gate);
      const GateState state = source.states[index];
      to.codes.push_back(
        state == GateState::Valid
          ? static_cast<std::uint16_t>(offset + stepsPerUnit * (source.values[index] - smallest))
          : CodeOf(state));
    }
    to.codes.push_back(to.codes.back());
  }
}

BeamSweep PrepareSweep(const PolarSweep& source, double beamWidth)
{
  BeamSweep sweep;
  const double elevation = MeanElevation(source);
  sweep.elevation = static_cast<float>(elevation);
  sweep.sine = static_cast<float>(std::sin(elevation * RadiansPerDegree));
  sweep.cosine = static_cast<float>(std::cos(elevation * RadiansPerDegree));
  sweep.firstGate = static_cast<float>(source.firstGate);
  sweep.gatesPerMetre = static_cast<float>(1.0 / source.gateSpacing);
  sweep.gates = static_cast<int>(source.gates);
  sweep.elevationNumber = source.elevationNumber;
  const auto earlier = [](const PolarRay& a, const PolarRay& b) { return a.time < b.time; };
  const auto times = std::minmax_element(source.rays.begin(), source.rays.end(), earlier);
  sweep.begin = times.first->time;
  sweep.end = times.second->time;
  const std::vector<SortedRay> entries = CloseTheCircle(SortRays(source));
  SetDirections(source, entries, beamWidth, sweep);
  SetCodes(source, entries, sweep);
  return sweep;
}

double ReachOf(const PolarSweep& sweep)
{
  return sweep.firstGate + (static_cast<double>(sweep.gates) - 0.5) * sweep.gateSpacing;
}

// The Doppler half of a split cut: its pulses follow so closely that it sees less far.
bool IsDopplerHalf(const PolarSweep& sweep, const PolarVolume& volume)
{
  const auto isSurveillanceHalf = [&sweep](const PolarSweep& other)
  {
    return other.elevationNumber != sweep.elevationNumber &&
           std::abs(MeanElevation(other) - MeanElevation(sweep)) <= SameTilt &&
           ReachOf(other) > 1.1 * ReachOf(sweep);
  };
  return volume.moment == MomentName::REF &&
         std::any_of(volume.sweeps.begin(), volume.sweeps.end(), isSurveillanceHalf);
}

} // namespace

std::size_t BeamVolume::MemoryBytes() const
{
  std::size_t bytes = sizeof(BeamVolume) + composite.values.size() * sizeof(float) +
                      composite.cells.size() * (sizeof(VolumeComposite::Cell) + 1);
  for (const BeamSweep& sweep : sweeps)
  {
    bytes += sizeof(BeamSweep) + 4 * sweep.azimuths.size() * sizeof(float) +
             sweep.firstEntries.size() * sizeof(std::uint32_t) +
             sweep.codes.size() * sizeof(std::uint16_t);
  }
  return bytes;
}

BeamVolume PrepareBeamVolume(const PolarVolume& volume, double beamWidth)
{
  BeamVolume prepared;
  prepared.site = volume.site;
  prepared.moment = volume.moment;
  prepared.start = volume.start;
  prepared.end = volume.end;
  prepared.synthetic = volume.synthetic;
  for (const PolarSweep& sweep : volume.sweeps)
  {
    const bool usable =
      !sweep.rays.empty() && sweep.gates > 0 && sweep.gateSpacing > 0.0 && ReachOf(sweep) > 0.0;
    if (usable && !IsDopplerHalf(sweep, volume))
    {
      prepared.sweeps.push_back(PrepareSweep(sweep, beamWidth));
    }
  }
  prepared.composite = MakeComposite(prepared.sweeps);
  return prepared;
}

} // namespace nexrad

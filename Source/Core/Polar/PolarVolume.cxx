// SPDX-License-Identifier: BSD-3-Clause
#include "nexrad/Polar/PolarVolume.h"

#include "nexrad/Model/Elevation.h"
#include "nexrad/Model/MomentLimits.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <utility>

namespace nexrad
{

namespace
{

using RayList = std::vector<const Ray*>;

// The rays of a sweep that have the moment, by gate geometry, in the order in which each geometry
// comes first. Nearly always there is one.
std::vector<RayList> GroupByGeometry(const Sweep& sweep, MomentName moment)
{
  std::vector<RayList> groups;
  std::map<std::pair<std::int32_t, std::int32_t>, std::size_t> places;
  for (const Ray& ray : sweep.rays)
  {
    const MomentRow& row = ray.Row(moment);
    if (row.gates > 0)
    {
      const auto place = places.emplace(std::pair(row.firstGate, row.gateSpacing), groups.size());
      if (place.second)
      {
        groups.emplace_back();
      }
      groups[place.first->second].push_back(&ray);
    }
  }
  return groups;
}

// What each word of 8 bits stands for: a sweep has hundreds of thousands of them.
class WordMeanings
{
public:
  void SetFor(const MomentRow& row)
  {
    if (known && like.scale == row.scale && like.offset == row.offset &&
        like.firstValue == row.firstValue)
    {
      return;
    }
    known = true;
    like = row;
    for (std::size_t word = 0; word < values.size(); ++word)
    {
      const auto byte = static_cast<std::uint8_t>(word);
      MomentRow one = row;
      one.words = &byte;
      one.wordBits = 8;
      states[word] = one.State(0);
      values[word] =
        states[word] == GateState::Valid ? one.Value(0) : std::numeric_limits<float>::quiet_NaN();
    }
  }
  float Value(std::uint8_t word) const { return values[word]; }
  GateState State(std::uint8_t word) const { return states[word]; }

private:
  bool known = false;
  MomentRow like;
  std::array<float, 256> values;
  std::array<GateState, 256> states;
};

void FillRayOfBytes(
  const MomentRow& row, const WordMeanings& meanings, std::size_t start, PolarSweep& sweep)
{
  for (std::size_t gate = 0; gate < row.gates; ++gate)
  {
    sweep.states[start + gate] = meanings.State(row.words[gate]);
    sweep.values[start + gate] = meanings.Value(row.words[gate]);
  }
}

void FillRay(const MomentRow& row, std::size_t start, PolarSweep& sweep)
{
  for (std::size_t gate = 0; gate < row.gates; ++gate)
  {
    const GateState state = row.State(gate);
    sweep.states[start + gate] = state;
    if (state == GateState::Valid)
    {
      sweep.values[start + gate] = row.Value(gate);
    }
  }
}

PolarSweep MakeSweep(const RayList& rays, Waveform waveform, MomentName moment)
{
  PolarSweep sweep;
  sweep.waveform = waveform;
  const MomentRow& first = rays.front()->Row(moment);
  sweep.elevationNumber = rays.front()->elevationNumber;
  sweep.firstGate = first.firstGate;
  sweep.gateSpacing = first.gateSpacing;
  for (const Ray* ray : rays)
  {
    sweep.gates = std::max<std::size_t>(sweep.gates, ray->Row(moment).gates);
    sweep.rays.push_back({ray->azimuth, ray->elevation, ray->time, ray->unambiguousRange});
  }
  const std::size_t count = rays.size() * sweep.gates;
  sweep.values.assign(count, std::numeric_limits<float>::quiet_NaN());
  sweep.states.assign(count, GateState::NotSampled);
  WordMeanings meanings;
  for (std::size_t index = 0; index < rays.size(); ++index)
  {
    const MomentRow& row = rays[index]->Row(moment);
    if (row.wordBits == 8)
    {
      meanings.SetFor(row);
      FillRayOfBytes(row, meanings, sweep.Index(index, 0), sweep);
    }
    else
    {
      FillRay(row, sweep.Index(index, 0), sweep);
    }
    for (const std::size_t gate : ImpossibleGates(*rays[index], moment))
    {
      sweep.values[sweep.Index(index, gate)] = std::numeric_limits<float>::quiet_NaN();
      sweep.states[sweep.Index(index, gate)] = GateState::NotSampled;
    }
  }
  return sweep;
}

// The first gate whose centre lies beyond the unambiguous range of a ray; all of them without one.
std::size_t GatesWithin(const PolarSweep& sweep, double unambiguousRange)
{
  if (!(unambiguousRange > 0.0))
  {
    return sweep.gates;
  }
  const double last = std::floor((unambiguousRange - sweep.firstGate) / sweep.gateSpacing);
  return static_cast<std::size_t>(std::clamp(last + 1.0, 0.0, static_cast<double>(sweep.gates)));
}

// Cuts off what lies behind the first `gates` gates of each ray.
void CutOff(PolarSweep& sweep, std::size_t gates)
{
  for (std::size_t ray = 1; ray < sweep.rays.size(); ++ray)
  {
    const auto from = static_cast<std::ptrdiff_t>(sweep.Index(ray, 0));
    const auto to = static_cast<std::ptrdiff_t>(ray * gates);
    const auto count = static_cast<std::ptrdiff_t>(gates);
    std::copy_n(sweep.values.begin() + from, count, sweep.values.begin() + to);
    std::copy_n(sweep.states.begin() + from, count, sweep.states.begin() + to);
  }
  sweep.gates = gates;
  sweep.values.resize(sweep.rays.size() * gates);
  sweep.states.resize(sweep.rays.size() * gates);
}

} // namespace

void LimitReach(PolarSweep& sweep)
{
  if (sweep.waveform == Waveform::Batch || sweep.waveform == Waveform::Unknown ||
      !(sweep.gateSpacing > 0.0))
  {
    return;
  }
  std::size_t sampled = 0;
  bool changed = false;
  for (std::size_t ray = 0; ray < sweep.rays.size(); ++ray)
  {
    const std::size_t within = GatesWithin(sweep, sweep.rays[ray].unambiguousRange);
    sampled = std::max(sampled, within);
    for (std::size_t gate = within; gate < sweep.gates; ++gate)
    {
      GateState& state = sweep.states[sweep.Index(ray, gate)];
      changed = changed || state == GateState::BelowThreshold;
      state = state == GateState::BelowThreshold ? GateState::NotSampled : state;
      sampled = state == GateState::NotSampled ? sampled : std::max(sampled, gate + 1);
    }
  }
  if (changed && sampled < sweep.gates)
  {
    CutOff(sweep, sampled);
  }
}

double MedianElevation(const PolarSweep& sweep)
{
  std::vector<double> elevations;
  for (const PolarRay& ray : sweep.rays)
  {
    elevations.push_back(ray.elevation);
  }
  return MedianOf(std::move(elevations));
}

PolarVolume MakePolarVolume(const RadarVolume& volume, MomentName moment)
{
  PolarVolume polar;
  polar.site = volume.site;
  polar.moment = moment;
  polar.start = volume.Start().value_or(Time{});
  polar.end = volume.End().value_or(Time{});
  polar.synthetic = volume.synthetic;
  for (const Sweep& sweep : volume.sweeps)
  {
    for (const RayList& rays : GroupByGeometry(sweep, moment))
    {
      polar.sweeps.push_back(MakeSweep(rays, sweep.waveform, moment));
      if (moment == MomentName::REF)
      {
        LimitReach(polar.sweeps.back());
      }
    }
  }
  return polar;
}

} // namespace nexrad

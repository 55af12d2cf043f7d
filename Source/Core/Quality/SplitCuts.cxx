// SPDX-License-Identifier: BSD-3-Clause
#include "nexrad/Quality/SplitCuts.h"

#include "nexrad/Model/Elevation.h"
#include "nexrad/Polar/SweepPairing.h"

#include <cmath>
#include <iterator>
#include <map>
#include <utility>

namespace nexrad
{

namespace
{

constexpr double sameDirection = 0.75; // degrees

using CutTable = std::map<int, const PolarSweep*>; // by elevation numbers

// The sweeps of a volume by their cuts: the one with the most rays where rays of several gate
// geometries make several.
CutTable MakeCutTable(const PolarVolume& volume)
{
  CutTable cuts;
  for (const PolarSweep& sweep : volume.sweeps)
  {
    if (!sweep.rays.empty() && sweep.gates > 0 && sweep.gateSpacing > 0.0)
    {
      const PolarSweep*& found = cuts[sweep.elevationNumber];
      found = !found || sweep.rays.size() > found->rays.size() ? &sweep : found;
    }
  }
  return cuts;
}

bool IsSameTilt(const PolarSweep& one, const PolarSweep& other)
{
  return std::abs(MedianElevation(one) - MedianElevation(other)) <= SameTilt;
}

// The cut itself where it has a moment, else its neighbour at the same tilt that does; nullptr
// where neither does. `after`: the later neighbour first.
const PolarSweep* FindCutWith(const CutTable& cuts, const PolarSweep& own, bool after)
{
  const int step = after ? 1 : -1;
  for (const int number :
    {own.elevationNumber, own.elevationNumber + step, own.elevationNumber - step})
  {
    const auto found = cuts.find(number);
    if (found != cuts.end() && IsSameTilt(*found->second, own))
    {
      return found->second;
    }
  }
  return nullptr;
}

MomentSource FindSource(const CutTable& cuts, const PolarSweep& own, bool after)
{
  MomentSource source;
  source.sweep = FindCutWith(cuts, own, after);
  if (source.sweep)
  {
    const RayFinder finder(*source.sweep);
    for (const PolarRay& ray : own.rays)
    {
      source.rays.push_back(finder.Nearest(static_cast<double>(ray.azimuth), sameDirection)
                              .value_or(MomentSource::NoRay));
    }
  }
  return source;
}

// Whether a sweep is the Doppler half of the split cut whose surveillance half is the one before.
bool IsDopplerHalf(const std::vector<PolarSweep>& all, const CutTable& velocity, std::size_t sweep)
{
  return sweep > 0 && IsSameTilt(all[sweep - 1], all[sweep]) &&
         all[sweep - 1].elevationNumber + 1 == all[sweep].elevationNumber &&
         velocity.count(all[sweep].elevationNumber) > 0 &&
         velocity.count(all[sweep - 1].elevationNumber) == 0;
}

} // namespace

MeasuredMoments::MeasuredMoments(const PolarVolume& theReflectivity, const MeasuredVolume& measured,
  const WantedRange& judged, const RangeLoop& loop)
  : reflectivity(theReflectivity)
{
  const std::pair<MomentName, PolarVolume*> others[] = {{MomentName::VEL, &velocity},
    {MomentName::SW, &width}, {MomentName::RHO, &correlation}, {MomentName::ZDR, &ratio},
    {MomentName::PHI, &phase}, {MomentName::CFP, &filterPower}};
  RunEach(loop, std::size(others),
    [&](std::size_t i) { *others[i].second = measured(others[i].first, judged); });
}

std::vector<SweepSources> FindSources(const MeasuredMoments& moments)
{
  const CutTable velocity = MakeCutTable(moments.velocity);
  const CutTable width = MakeCutTable(moments.width);
  const CutTable correlation = MakeCutTable(moments.correlation);
  const CutTable ratio = MakeCutTable(moments.ratio);
  const CutTable phase = MakeCutTable(moments.phase);
  const CutTable filterPower = MakeCutTable(moments.filterPower);
  std::vector<SweepSources> all;
  for (std::size_t i = 0; i < moments.reflectivity.sweeps.size(); ++i)
  {
    // In a split cut velocity comes after reflectivity, and polarimetry before it.
    const PolarSweep& own = moments.reflectivity.sweeps[i];
    SweepSources sources;
    sources.velocity = FindSource(velocity, own, true);
    sources.width = FindSource(width, own, true);
    sources.correlation = FindSource(correlation, own, false);
    sources.ratio = FindSource(ratio, own, false);
    sources.phase = FindSource(phase, own, false);
    sources.filterPower = FindSource(filterPower, own, false);
    if (IsDopplerHalf(moments.reflectivity.sweeps, velocity, i))
    {
      sources.surveillance = i - 1;
    }
    all.push_back(std::move(sources));
  }
  return all;
}

} // namespace nexrad

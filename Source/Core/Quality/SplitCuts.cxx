// SPDX-License-Identifier: BSD-3-Clause
#include "nexrad/Quality/SplitCuts.h"

#include "nexrad/Model/Elevation.h"
#include "nexrad/Polar/SweepPairing.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>
#include <utility>

namespace nexrad
{

namespace
{

constexpr double sameDirection = 0.75; // degrees

// The sweeps of a volume by their cuts.
class CutTable
{
public:
  explicit CutTable(const PolarVolume& volume)
  {
    for (const PolarSweep& sweep : volume.sweeps)
    {
      const bool serves = !sweep.rays.empty() && sweep.gates > 0 && sweep.gateSpacing > 0.0;
      const PolarSweep*& found = cuts[sweep.elevationNumber];
      found = serves && (!found || sweep.rays.size() > found->rays.size()) ? &sweep : found;
    }
  }

  // The sweep of a cut, the one with the most rays where rays of several gate geometries make
  // several; nullptr when the volume has none.
  const PolarSweep* Find(int elevationNumber) const
  {
    const auto found = cuts.find(elevationNumber);
    return found == cuts.end() ? nullptr : found->second;
  }

private:
  std::map<int, const PolarSweep*> cuts;
};

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
    const PolarSweep* found = cuts.Find(number);
    if (found && IsSameTilt(*found, own))
    {
      return found;
    }
  }
  return nullptr;
}

// Whether two moments are of the same rays.
bool HaveSameRays(const PolarSweep& one, const PolarSweep& other)
{
  return std::equal(one.rays.begin(), one.rays.end(), other.rays.begin(), other.rays.end(),
    [](const PolarRay& a, const PolarRay& b) { return a.azimuth == b.azimuth; });
}

// `alike`: a source of another moment for the same sweep, whose rays are nearly always the same.
MomentSource FindSource(
  const CutTable& cuts, const PolarSweep& own, bool after, const MomentSource& alike = {})
{
  MomentSource source;
  source.sweep = FindCutWith(cuts, own, after);
  if (source.sweep && alike.sweep && HaveSameRays(*source.sweep, *alike.sweep))
  {
    source.rays = alike.rays;
  }
  else if (source.sweep)
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
         velocity.Find(all[sweep].elevationNumber) != nullptr &&
         velocity.Find(all[sweep - 1].elevationNumber) == nullptr;
}

} // namespace

MeasuredMoments::MeasuredMoments(const PolarVolume& theReflectivity, const MeasuredVolume& measured,
  const WantedRange& judged, const RangeLoop& loop)
  : reflectivity(theReflectivity)
{
  const std::pair<MomentName, PolarVolume*> others[] = {{MomentName::VEL, &velocity},
    {MomentName::SW, &width}, {MomentName::RHO, &correlation}, {MomentName::ZDR, &ratio},
    {MomentName::PHI, &phase}, {MomentName::CFP, &filterPower}};
  RunLoop(loop, static_cast<int>(std::size(others)),
    [&](int begin, int end)
    {
      for (auto i = static_cast<std::size_t>(begin); i < static_cast<std::size_t>(end); ++i)
      {
        *others[i].second = measured(others[i].first, judged);
      }
    });
}

std::vector<SweepSources> FindSources(const MeasuredMoments& moments)
{
  const CutTable velocity(moments.velocity);
  const CutTable width(moments.width);
  const CutTable correlation(moments.correlation);
  const CutTable ratio(moments.ratio);
  const CutTable phase(moments.phase);
  const CutTable filterPower(moments.filterPower);
  std::vector<SweepSources> all;
  for (std::size_t i = 0; i < moments.reflectivity.sweeps.size(); ++i)
  {
    // In a split cut velocity comes after reflectivity, and polarimetry before it.
    const PolarSweep& own = moments.reflectivity.sweeps[i];
    SweepSources sources;
    sources.velocity = FindSource(velocity, own, true);
    sources.width = FindSource(width, own, true, sources.velocity);
    sources.correlation = FindSource(correlation, own, false);
    sources.ratio = FindSource(ratio, own, false, sources.correlation);
    sources.phase = FindSource(phase, own, false, sources.correlation);
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

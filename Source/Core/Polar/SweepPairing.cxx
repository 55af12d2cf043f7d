// SPDX-License-Identifier: BSD-3-Clause
#include "nexrad/Polar/SweepPairing.h"

#include "nexrad/Geometry/Angles.h"
#include "nexrad/Model/Elevation.h"
#include "nexrad/Model/SiteTable.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <iterator>
#include <tuple>

namespace nexrad
{

namespace
{

constexpr double sameElevation = 0.3; // degrees; neighbouring cuts lie at least 0.4° apart

// What tells a sweep from the others of its volume.
struct SweepRank
{
  double elevation = 0.0;
  int repetition = 0; // earlier sweeps of the volume at the same elevation
};

std::vector<SweepRank> RankSweeps(const PolarVolume& volume)
{
  std::vector<SweepRank> ranks;
  for (const PolarSweep& sweep : volume.sweeps)
  {
    const double elevation = MedianElevation(sweep);
    const auto same = [elevation](const SweepRank& other)
    { return std::abs(other.elevation - elevation) <= 0.5 * sameElevation; };
    ranks.push_back({elevation, static_cast<int>(std::count_if(ranks.begin(), ranks.end(), same))});
  }
  return ranks;
}

// Whether reflectivity of a sweep comes from pulses that follow so closely that echo from beyond
// their range falls on nearer gates, where another cut is to tell it.
bool NeedsLongPulses(const PolarSweep& sweep, const Site& site)
{
  return sweep.waveform == Waveform::ContiguousDoppler ||
         (sweep.waveform == Waveform::ContiguousDopplerWithout && !IsTerminal(site));
}

// The half of a split cut that reflectivity is taken from; nullptr where the sweep is no Doppler
// half, or has lost the other one.
const PolarSweep* FindSurveillanceHalf(const PolarVolume& volume, std::size_t index)
{
  const PolarSweep& sweep = volume.sweeps[index];
  if (volume.moment != MomentName::REF || !NeedsLongPulses(sweep, volume.site))
  {
    return nullptr;
  }
  const double elevation = MedianElevation(sweep);
  for (std::size_t i = index; i-- > 0;)
  {
    const PolarSweep& before = volume.sweeps[i];
    if (std::abs(MedianElevation(before) - elevation) > SameTilt)
    {
      return nullptr;
    }
    if (before.waveform == Waveform::ContiguousSurveillance || before.waveform == Waveform::Batch)
    {
      return &before;
    }
  }
  return nullptr;
}

} // namespace

std::vector<std::optional<std::size_t>> PairSweeps(
  const PolarVolume& before, const PolarVolume& after)
{
  const std::vector<SweepRank> ranksBefore = RankSweeps(before);
  const std::vector<SweepRank> ranksAfter = RankSweeps(after);
  std::vector<std::optional<std::size_t>> pairs(before.sweeps.size());
  for (std::size_t i = 0; i < before.sweeps.size(); ++i)
  {
    // Smaller is better, compared from the first item on.
    std::tuple<bool, int, double> best;
    for (std::size_t j = 0; j < after.sweeps.size(); ++j)
    {
      const double apart = std::abs(ranksBefore[i].elevation - ranksAfter[j].elevation);
      if (apart > sameElevation || after.sweeps[j].rays.empty())
      {
        continue;
      }
      const auto candidate =
        std::make_tuple(before.sweeps[i].elevationNumber != after.sweeps[j].elevationNumber,
          std::abs(ranksBefore[i].repetition - ranksAfter[j].repetition), apart);
      if (!pairs[i] || candidate < best)
      {
        pairs[i] = j;
        best = candidate;
      }
    }
  }
  return pairs;
}

RayFinder::RayFinder(const PolarSweep& sweep)
{
  rays.reserve(sweep.rays.size());
  for (std::size_t i = 0; i < sweep.rays.size(); ++i)
  {
    rays.emplace_back(ToFullTurn(static_cast<double>(sweep.rays[i].azimuth)), i);
  }
  std::sort(rays.begin(), rays.end());
}

std::optional<std::size_t> RayFinder::Nearest(double azimuth, double tolerance) const
{
  if (rays.empty())
  {
    return std::nullopt;
  }
  const double wanted = ToFullTurn(azimuth);
  const auto next =
    std::lower_bound(rays.begin(), rays.end(), std::make_pair(wanted, std::size_t(0)));
  const auto& above = next == rays.end() ? rays.front() : *next;
  const auto& below = next == rays.begin() ? rays.back() : *std::prev(next);
  const double toAbove = AngleBetween(wanted, above.first);
  const double toBelow = AngleBetween(wanted, below.first);
  if (std::min(toAbove, toBelow) > tolerance)
  {
    return std::nullopt;
  }
  return toBelow <= toAbove ? below.second : above.second;
}

std::vector<std::size_t> FindRaysOfCut(const PolarSweep& sweep, double beamWidth)
{
  const double elevation = MedianElevation(sweep);
  std::vector<std::size_t> rays;
  for (std::size_t ray = 0; ray < sweep.rays.size(); ++ray)
  {
    if (!IsStray(static_cast<double>(sweep.rays[ray].elevation), elevation, beamWidth))
    {
      rays.push_back(ray);
    }
  }
  return HasElevation(rays.size(), sweep.rays.size()) ? rays : std::vector<std::size_t>();
}

void LeaveOutSeenTwice(
  const PolarVolume& volume, std::size_t index, double beamWidth, std::vector<std::size_t>& rays)
{
  const PolarSweep* surveillance = FindSurveillanceHalf(volume, index);
  if (surveillance == nullptr || FindRaysOfCut(*surveillance, beamWidth).empty())
  {
    return;
  }
  const PolarSweep& sweep = volume.sweeps[index];
  const RayFinder finder(*surveillance);
  const double elevation = MedianElevation(*surveillance);
  const auto seen = [&](std::size_t ray)
  {
    const auto other = finder.Nearest(static_cast<double>(sweep.rays[ray].azimuth), beamWidth);
    return other && !IsStray(static_cast<double>(surveillance->rays[*other].elevation), elevation,
                      beamWidth);
  };
  rays.erase(std::remove_if(rays.begin(), rays.end(), seen), rays.end());
}

} // namespace nexrad

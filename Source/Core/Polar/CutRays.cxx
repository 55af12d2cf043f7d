// SPDX-License-Identifier: BSD-3-Clause
#include "nexrad/Polar/CutRays.h"

#include "nexrad/Model/Elevation.h"
#include "nexrad/Model/SiteTable.h"
#include "nexrad/Polar/SweepPairing.h"

#include <algorithm>
#include <cmath>

namespace nexrad
{

namespace
{

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

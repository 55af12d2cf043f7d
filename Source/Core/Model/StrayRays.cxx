// SPDX-License-Identifier: BSD-3-Clause
#include "nexrad/Model/StrayRays.h"

#include "nexrad/Model/Elevation.h"
#include "nexrad/Model/SiteTable.h"

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <sstream>

namespace nexrad
{

namespace
{

// Whether all rays of a sweep point the same way but for their elevation.
bool HasOneAzimuth(const Sweep& sweep, double beamWidth)
{
  const double first = static_cast<double>(sweep.rays.front().azimuth);
  return std::all_of(sweep.rays.begin(), sweep.rays.end(),
    [=](const Ray& ray)
    {
      const double turn = std::remainder(static_cast<double>(ray.azimuth) - first, 360.0);
      return std::abs(turn) <= 2.0 * beamWidth;
    });
}

std::string Describe(
  const Sweep& sweep, std::size_t index, const std::vector<const Ray*>& strays, double beamWidth)
{
  const auto ends = std::minmax_element(strays.begin(), strays.end(),
    [](const Ray* a, const Ray* b) { return a->elevation < b->elevation; });
  std::ostringstream text;
  text << std::fixed << std::setprecision(2) << "sweep " << index << " (elevation number "
       << sweep.elevationNumber << ") ";
  if (!HasElevation(sweep.rays.size() - strays.size(), sweep.rays.size()))
  {
    text << "has no elevation, because " << strays.size() << " of its " << sweep.rays.size()
         << " rays are farther from their median, " << sweep.MedianElevation()
         << " degrees, than half a beam width, from " << (*ends.first)->elevation << " to "
         << (*ends.second)->elevation << " degrees";
    if (HasOneAzimuth(sweep, beamWidth))
    {
      text << " (a scan in elevation at azimuth " << sweep.rays.front().azimuth << " degrees)";
    }
    text << "; the merge leaves the sweep out";
    return text.str();
  }
  text << "has its elevation at " << sweep.MedianElevation() << " degrees, and " << strays.size()
       << " of its " << sweep.rays.size() << " rays farther from it than half a beam width, from "
       << (*ends.first)->elevation << " to " << (*ends.second)->elevation
       << " degrees; the merge leaves them out";
  return text.str();
}

} // namespace

std::vector<std::string> DescribeStrays(const RadarVolume& volume)
{
  const double beamWidth = BeamWidthOf(volume.site);
  std::vector<std::string> lines;
  for (std::size_t index = 0; index < volume.sweeps.size(); ++index)
  {
    const Sweep& sweep = volume.sweeps[index];
    const std::vector<const Ray*> strays = sweep.StrayRays(beamWidth);
    if (!strays.empty())
    {
      lines.push_back(Describe(sweep, index, strays, beamWidth));
    }
  }
  return lines;
}

} // namespace nexrad

// SPDX-License-Identifier: BSD-3-Clause
#include "nexrad/Model/StrayRays.h"

#include "nexrad/Model/Elevation.h"
#include "nexrad/Model/SiteTable.h"
#include "nexrad/System/MessageText.h"

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

std::string SummarizeStrays(const RadarVolume& volume)
{
  const double beamWidth = BeamWidthOf(volume.site);
  std::size_t rays = 0;
  std::size_t sweeps = 0;
  std::size_t whole = 0;
  for (const Sweep& sweep : volume.sweeps)
  {
    const std::size_t strays = sweep.StrayRays(beamWidth).size();
    const bool hasElevation = HasElevation(sweep.rays.size() - strays, sweep.rays.size());
    rays += hasElevation ? strays : 0;
    sweeps += hasElevation && strays > 0 ? 1 : 0;
    whole += hasElevation ? 0 : 1;
  }
  std::string text;
  if (rays > 0)
  {
    text = CountText(rays, "ray") + " of " + CountText(sweeps, "sweep") +
           ", farther from the elevation of the sweep than half a beam width";
  }
  if (whole > 0)
  {
    text += (text.empty() ? "" : "; and ") + CountText(whole, "sweep") +
            " without an elevation, because most rays are that far from their median";
  }
  return text.empty() ? text : "the merge leaves out " + text;
}

} // namespace nexrad

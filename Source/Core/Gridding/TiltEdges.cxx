// SPDX-License-Identifier: BSD-3-Clause
#include "Gridding/TiltEdges.h"

#include "Geometry/Angles.h"

#include <algorithm>
#include <cmath>

namespace nexrad
{

namespace
{

double TangentOf(double elevation)
{
  return std::tan(elevation * RadiansPerDegree);
}

// Differences over less than the pattern's standard deviation are noise more than slope.
float SpreadOver(double gap, double beamWidth)
{
  const double sigma = beamWidth / std::sqrt(16.0 * std::log(2.0)); // degrees
  return static_cast<float>(std::log(10.0) / 10.0 * std::min(sigma / gap, 1.0));
}

} // namespace

std::vector<TiltEdges> FindEdges(const std::vector<BeamTilt>& tilts, double beamWidth, bool sharpen)
{
  const double half = 0.5 * beamWidth;
  std::vector<TiltEdges> edges(tilts.size());
  for (std::size_t i = 0; i < tilts.size(); ++i)
  {
    const double elevation = static_cast<double>(tilts[i].elevation);
    edges[i].elevation = tilts[i].elevation;
    edges[i].tangent = tilts[i].tangent;
    edges[i].perDegree =
      (1.0F + tilts[i].tangent * tilts[i].tangent) * static_cast<float>(RadiansPerDegree);
    edges[i].lower = static_cast<float>(TangentOf(elevation - half));
    edges[i].upper = static_cast<float>(TangentOf(std::min(elevation + half, 89.9)));
    if (i + 1 < tilts.size())
    {
      const double next = static_cast<double>(tilts[i + 1].elevation);
      const double from = TangentOf(elevation);
      const double middle = 0.5 * (from + TangentOf(next));
      const double share = (std::atan(middle) / RadiansPerDegree - elevation) / (next - elevation);
      edges[i].middle = static_cast<float>(TangentOf(0.5 * (elevation + next)));
      edges[i].bend = static_cast<float>(4.0 * share - 2.0);
      const double end = std::max(0.5, 1.0 - half / (next - elevation));
      edges[i].endAbove = static_cast<float>(TangentOf(elevation + end * (next - elevation)));
      edges[i].endBelow = static_cast<float>(TangentOf(next - end * (next - elevation)));
      edges[i].endShare = static_cast<float>(end);
      edges[i].spread = sharpen ? SpreadOver(next - elevation, beamWidth) : 0.0F;
    }
  }
  return edges;
}

} // namespace nexrad

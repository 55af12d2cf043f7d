// SPDX-License-Identifier: BSD-3-Clause
#include "nexrad/Beams/TiltEdges.h"

#include "nexrad/Geometry/Angles.h"

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

// In the middle of gaps of one width the cubic through four points is 1/16 of the differences
// beyond away from the line between the two; there share·(1 − share) is 1/4. A slope over a
// narrower gap is not carried farther than that gap.
float TrendOver(double beyond, double gap)
{
  return static_cast<float>(0.25 * std::min(1.0, gap / beyond));
}

// How the value changes from one tilt to another; 0 when that is not known.
float StepTo(float to, float from)
{
  const float step = to - from;
  return std::isnan(step) ? 0.0F : step;
}

} // namespace

std::vector<TiltEdges> FindEdges(const std::vector<float>& elevations, double beamWidth)
{
  const double half = 0.5 * beamWidth;
  std::vector<TiltEdges> edges(elevations.size());
  for (std::size_t i = 0; i < elevations.size(); ++i)
  {
    const double elevation = static_cast<double>(elevations[i]);
    const auto tangent = static_cast<float>(TangentOf(elevation));
    edges[i].elevation = elevations[i];
    edges[i].tangent = tangent;
    edges[i].perDegree = (1.0F + tangent * tangent) * static_cast<float>(RadiansPerDegree);
    edges[i].lower = static_cast<float>(TangentOf(elevation - half));
    edges[i].upper = static_cast<float>(TangentOf(std::min(elevation + half, 89.9)));
    if (i + 1 < elevations.size())
    {
      const double next = static_cast<double>(elevations[i + 1]);
      const double from = TangentOf(elevation);
      const double middle = 0.5 * (from + TangentOf(next));
      const double share = (std::atan(middle) / RadiansPerDegree - elevation) / (next - elevation);
      edges[i].middle = static_cast<float>(TangentOf(0.5 * (elevation + next)));
      edges[i].bend = static_cast<float>(4.0 * share - 2.0);
      const double end = std::max(0.5, 1.0 - half / (next - elevation));
      edges[i].endAbove = static_cast<float>(TangentOf(elevation + end * (next - elevation)));
      edges[i].endBelow = static_cast<float>(TangentOf(next - end * (next - elevation)));
      edges[i].endShare = static_cast<float>(end);
      const double gap = next - elevation;
      if (i > 0)
      {
        edges[i].trendBelow = TrendOver(elevation - static_cast<double>(elevations[i - 1]), gap);
      }
      if (i + 2 < elevations.size())
      {
        edges[i].trendAbove = TrendOver(static_cast<double>(elevations[i + 2]) - next, gap);
      }
    }
  }
  return edges;
}

TiltInterpolation::TiltInterpolation(const TiltGapValues& values, const TiltEdges& edges)
  : from(values.lower)
  , perShare(values.upper - values.lower)
  , curve(edges.trendBelow * StepTo(values.lower, values.below) -
          edges.trendAbove * StepTo(values.above, values.upper))
{
  if (values.lowerEcho && !values.upperEcho)
  {
    perShare = -values.lower / edges.endShare;
  }
  else if (values.upperEcho && !values.lowerEcho)
  {
    perShare = values.upper / edges.endShare;
    from = values.upper - perShare;
  }
  else if (!values.lowerEcho && !values.upperEcho)
  {
    curve = 0.0F; // between two tilts without echo there is none
  }
}

} // namespace nexrad

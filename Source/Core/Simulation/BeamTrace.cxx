// SPDX-License-Identifier: BSD-3-Clause
#include "nexrad/Simulation/BeamTrace.h"

#include "nexrad/Geometry/Angles.h"
#include "nexrad/Simulation/BeamPattern.h"

#include <GeographicLib/Geodesic.hpp>
#include <GeographicLib/GeodesicLine.hpp>

#include <algorithm>
#include <cmath>

namespace nexrad
{

namespace
{

constexpr double elevationMargin = 0.5; // degrees that a ray may lie off its cut

// Newton's forward differences of equally spaced values, each divided by the factorial of its
// order.
template <std::size_t Count>
void ToDifferences(std::array<double, Count>& values)
{
  for (std::size_t order = 1; order < Count; ++order)
  {
    for (std::size_t index = Count - 1; index >= order; --index)
    {
      values[index] = (values[index] - values[index - 1]) / static_cast<double>(order);
    }
  }
}

template <std::size_t Count>
double Evaluate(const std::array<double, Count>& differences, double position)
{
  double value = differences[Count - 1];
  for (std::size_t order = Count - 1; order-- > 0;)
  {
    value = value * (position - static_cast<double>(order)) + differences[order];
  }
  return value;
}

} // namespace

BeamTrace::BeamTrace(const Position& antenna, double cutElevation, double farthestRange,
  const BeamSamplerOptions& options)
  : site(antenna)
  , sigma(options.beamWidth / std::sqrt(16.0 * std::log(2.0)))
  , farthest(farthestRange)
  , path(options.effectiveRadiusFactor, cutElevation - elevationMargin - FarthestNode * sigma,
      cutElevation + elevationMargin + FarthestNode * sigma, farthestRange)
{
}

BeamTrace::Track BeamTrace::TraceGround(double bearing) const
{
  const GeographicLib::GeodesicLine line =
    GeographicLib::Geodesic::WGS84().Line(site.latitude, site.longitude, bearing);
  Track track;
  for (std::size_t node = 0; node < nodes; ++node)
  {
    double latitude = 0.0;
    double longitude = 0.0;
    line.Position(farthest * static_cast<double>(node) / (nodes - 1), latitude, longitude);
    const PlanePoint point = StormPlane::FromGeographic(longitude, latitude, 0.0);
    track.x[node] = point.x;
    track.y[node] = point.y;
  }
  ToDifferences(track.x);
  ToDifferences(track.y);
  return track;
}

void BeamTrace::Point(double rayAzimuth, double rayElevation)
{
  azimuth = rayAzimuth;
  elevation = rayElevation;
  const double side = Root3 * sigma / std::cos(elevation * RadiansPerDegree);
  tracks = {this->TraceGround(azimuth - side), this->TraceGround(azimuth),
    this->TraceGround(azimuth + side)};
}

PlanePoint BeamTrace::Place(const Track& track, const PathPoint& point) const
{
  const double position = point.groundDistance / farthest * (nodes - 1);
  return {Evaluate(track.x, position), Evaluate(track.y, position), point.height + site.altitude};
}

Cylinder BeamTrace::Span(double nearest, double end) const
{
  constexpr double slack = 100.0; // m, for what curves between the ends
  const PlanePoint middle = this->Centre((nearest + end) / 2.0);
  const double stretch = StormPlane::EastwardScale(site.latitude + farthest / 111'000.0);
  const double width = Root3 * sigma * RadiansPerDegree * end;
  Cylinder bounds{
    middle.x, middle.y, std::max(stretch, 1.0) * ((end - nearest) / 2.0 + width) + slack, 0.0, 0.0};
  const double low = elevation - FarthestNode * sigma;
  const double high = elevation + FarthestNode * sigma;
  bounds.bottom =
    site.altitude - slack + std::min({path.At(nearest, low).height, path.At(end, low).height});
  bounds.top = site.altitude + slack + path.At(end, high).height;
  return bounds;
}

BeamTrace::GateTracks BeamTrace::TracksAt(double groundDistance) const
{
  constexpr double step = 1'000.0; // m, over which a geodesic is straight
  GateTracks straight{};
  for (std::size_t side = 0; side < tracks.size(); ++side)
  {
    const PlanePoint here = this->Place(tracks[side], {0.0, groundDistance});
    const PlanePoint ahead = this->Place(tracks[side], {0.0, groundDistance + step});
    straight[side] = {here, (ahead.x - here.x) / step, (ahead.y - here.y) / step};
  }
  return straight;
}

} // namespace nexrad

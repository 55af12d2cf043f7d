// SPDX-License-Identifier: BSD-3-Clause
#include "nexrad/Simulation/BeamTrace.h"

#include "nexrad/Geometry/Angles.h"

#include <GeographicLib/Geodesic.hpp>
#include <GeographicLib/GeodesicLine.hpp>

#include <algorithm>
#include <cmath>

namespace nexrad
{

namespace
{

constexpr double earthRadius = 6'371'000.0; // m
constexpr double rayStep = 0.1;             // degrees between traced rays
constexpr double rangeStep = 1'000.0;       // m between points of a ray

// Where a ray is, and its angle above the local horizon in rad.
struct RayState
{
  double height;
  double distance;
  double angle;
};

// Change of the state a metre along the ray; `gradient` is d(ln n)/dh in 1/m.
RayState Slope(const RayState& state, double gradient)
{
  const double cosine = std::cos(state.angle);
  const double radius = earthRadius + state.height;
  return {std::sin(state.angle), earthRadius * cosine / radius, cosine * (1.0 / radius + gradient)};
}

RayState Advance(const RayState& state, const RayState& slope, double step)
{
  return {state.height + step * slope.height, state.distance + step * slope.distance,
    state.angle + step * slope.angle};
}

// One step of the classical Runge-Kutta method.
RayState Step(const RayState& state, double gradient)
{
  const RayState first = Slope(state, gradient);
  const RayState second = Slope(Advance(state, first, rangeStep / 2.0), gradient);
  const RayState third = Slope(Advance(state, second, rangeStep / 2.0), gradient);
  const RayState fourth = Slope(Advance(state, third, rangeStep), gradient);
  RayState next = Advance(state, first, rangeStep / 6.0);
  next = Advance(next, second, rangeStep / 3.0);
  next = Advance(next, third, rangeStep / 3.0);
  return Advance(next, fourth, rangeStep / 6.0);
}

} // namespace

RefractedPath::RefractedPath(double effectiveRadiusFactor, double lowestElevation,
  double highestElevation, double farthestRange)
  : lowest(lowestElevation)
  , steps(static_cast<std::size_t>(std::ceil(farthestRange / rangeStep)) + 1)
  , rays(static_cast<std::size_t>(std::ceil((highestElevation - lowestElevation) / rayStep)) + 1)
{
  const double gradient = (1.0 / effectiveRadiusFactor - 1.0) / earthRadius;
  points.reserve(steps * rays);
  for (std::size_t ray = 0; ray < rays; ++ray)
  {
    RayState state{0.0, 0.0, (lowest + rayStep * static_cast<double>(ray)) * RadiansPerDegree};
    for (std::size_t step = 0; step < steps; ++step)
    {
      points.push_back({state.height, state.distance});
      state = Step(state, gradient);
    }
  }
}

PathPoint RefractedPath::At(double range, double elevation) const
{
  const double alongRays =
    std::clamp((elevation - lowest) / rayStep, 0.0, static_cast<double>(rays - 1));
  const double alongRange = std::clamp(range / rangeStep, 0.0, static_cast<double>(steps - 1));
  const std::size_t ray = std::min(static_cast<std::size_t>(alongRays), rays - 2);
  const std::size_t step = std::min(static_cast<std::size_t>(alongRange), steps - 2);
  const double up = alongRays - static_cast<double>(ray);
  const double out = alongRange - static_cast<double>(step);
  const PathPoint* lower = &points[ray * steps + step];
  const PathPoint* upper = lower + steps;
  const auto blend = [up, out](double nearLow, double farLow, double nearHigh, double farHigh)
  {
    return (1.0 - up) * ((1.0 - out) * nearLow + out * farLow) +
           up * ((1.0 - out) * nearHigh + out * farHigh);
  };
  return {blend(lower[0].height, lower[1].height, upper[0].height, upper[1].height),
    blend(lower[0].groundDistance, lower[1].groundDistance, upper[0].groundDistance,
      upper[1].groundDistance)};
}

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

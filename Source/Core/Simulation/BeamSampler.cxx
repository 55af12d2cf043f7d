// SPDX-License-Identifier: BSD-3-Clause
#include "Simulation/BeamSampler.h"

#include <GeographicLib/Geodesic.hpp>
#include <GeographicLib/GeodesicLine.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace nexrad
{

namespace
{

constexpr double degree = 3.14159265358979323846 / 180.0;
constexpr double nothing = -std::numeric_limits<double>::infinity();
constexpr double elevationMargin = 0.5; // degrees that a ray may lie off its cut
constexpr double blockLength = 8'000.0; // m, over which storms are looked for at once

const double root3 = std::sqrt(3.0);

double ToZ(double decibel)
{
  constexpr double perDecibel = 0.23025850929940457; // ln(10)/10
  return std::exp(perDecibel * decibel);
}

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

PlanePoint Halfway(const PlanePoint& first, const PlanePoint& second)
{
  return {(first.x + second.x) / 2.0, (first.y + second.y) / 2.0, (first.z + second.z) / 2.0};
}

} // namespace

BeamSampler::BeamSampler(const Position& antenna, double cutElevation, double farthestRange,
  const BeamSamplerOptions& options)
  : site(antenna)
  , sigma(options.beamWidth / std::sqrt(16.0 * std::log(2.0)))
  , farthest(farthestRange)
  , path(options.effectiveRadiusFactor, cutElevation - elevationMargin - 2.0 * sigma,
      cutElevation + elevationMargin + 2.0 * sigma, farthestRange)
{
}

BeamSampler::Track BeamSampler::TraceGround(double azimuth) const
{
  const GeographicLib::GeodesicLine line =
    GeographicLib::Geodesic::WGS84().Line(site.latitude, site.longitude, azimuth);
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

void BeamSampler::Point(double azimuth, double rayElevation)
{
  elevation = rayElevation;
  const double side = 2.0 * sigma / std::cos(elevation * degree);
  tracks = {this->TraceGround(azimuth - side), this->TraceGround(azimuth),
    this->TraceGround(azimuth + side)};
}

PlanePoint BeamSampler::Place(const Track& track, const PathPoint& point) const
{
  const double position = point.groundDistance / farthest * (nodes - 1);
  return {Evaluate(track.x, position), Evaluate(track.y, position), point.height + site.altitude};
}

PlanePoint BeamSampler::Centre(double range) const
{
  return this->Place(tracks[1], path.At(range, elevation));
}

ElementBounds BeamSampler::BlockBounds(double nearest, double end) const
{
  constexpr double slack = 100.0; // m, for what curves between the ends
  const PlanePoint middle = this->Centre((nearest + end) / 2.0);
  const double stretch = StormPlane::EastwardScale(site.latitude + farthest / 111'000.0);
  const double width = 2.0 * sigma * degree * end;
  ElementBounds bounds{
    middle.x, middle.y, std::max(stretch, 1.0) * ((end - nearest) / 2.0 + width) + slack, 0.0, 0.0};
  const double low = elevation - root3 * sigma;
  const double high = elevation + root3 * sigma;
  bounds.bottom =
    site.altitude - slack + std::min({path.At(nearest, low).height, path.At(end, low).height});
  bounds.top = site.altitude + slack + path.At(end, high).height;
  return bounds;
}

double BeamSampler::MeanZ(const StormSnapshot& snapshot, double range) const
{
  const auto z = [this, &snapshot](const PlanePoint& point)
  { return ToZ(snapshot.Reflectivity(point, candidates)); };

  const PathPoint middle = path.At(range, elevation);
  double rim = z(this->Place(tracks[0], middle)) + z(this->Place(tracks[2], middle));
  for (const double side : {-root3, root3})
  {
    const PathPoint point = path.At(range, elevation + side * sigma);
    const PlanePoint centre = this->Place(tracks[1], point);
    rim += z(Halfway(this->Place(tracks[0], point), centre)) +
           z(Halfway(this->Place(tracks[2], point), centre));
  }
  return z(this->Place(tracks[1], middle)) / 2.0 + rim / 12.0;
}

void BeamSampler::Sample(
  const StormSnapshot& snapshot, const GateLayout& layout, std::vector<double>& reflectivity)
{
  reflectivity.assign(static_cast<std::size_t>(layout.gates), nothing);
  const double half = layout.gateSpacing / 2.0;
  const double gaussOffset = layout.gateSpacing > 500 ? half / root3 : 0.0;
  const int blockGates = std::max(1, static_cast<int>(blockLength / layout.gateSpacing));
  for (int first = 0; first < layout.gates; first += blockGates)
  {
    const int last = std::min(first + blockGates, layout.gates) - 1;
    const ElementBounds reach = this->BlockBounds(
      std::max(layout.Range(first) - half, 0.0), std::max(layout.Range(last) + half, 0.0));
    snapshot.FindElements(reach, candidates);
    if (candidates.empty() && reach.bottom > StormSnapshot::ClearAirTop())
    {
      continue;
    }
    for (int gate = first; gate <= last; ++gate)
    {
      // The antenna itself is the nearest that a gate reaches.
      const double range = std::max(layout.Range(gate), half);
      const double z = gaussOffset > 0.0 ? (this->MeanZ(snapshot, range - gaussOffset) +
                                             this->MeanZ(snapshot, range + gaussOffset)) /
                                             2.0
                                         : this->MeanZ(snapshot, range);
      reflectivity[static_cast<std::size_t>(gate)] = z > 0.0 ? 10.0 * std::log10(z) : nothing;
    }
  }
}

} // namespace nexrad

// SPDX-License-Identifier: BSD-3-Clause
#include "nexrad/Simulation/BeamSampler.h"

#include <GeographicLib/Geodesic.hpp>
#include <GeographicLib/GeodesicLine.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace nexrad
{

namespace
{

constexpr double degree = 3.14159265358979323846 / 180.0;
constexpr double nothing = -std::numeric_limits<double>::infinity();
constexpr double elevationMargin = 0.5; // degrees that a ray may lie off its cut
constexpr double partLength = 40'000.0; // m, over which storms are looked for first
constexpr double blockLength = 4'000.0; // m, over which they are looked for among those

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

// A direction off the beam's middle, in standard deviations of the pattern, and its weight.
struct QuadratureNode
{
  double position;
  double weight;
};
constexpr double root3 = 1.7320508075688772;

// The Gauss-Hermite rule of three nodes: for what is smooth across the beam.
constexpr std::array<QuadratureNode, 3> smoothNodes = {
  {{-root3, 1.0 / 6.0}, {0.0, 2.0 / 3.0}, {root3, 1.0 / 6.0}}};

// Equal steps weighted with the pattern: storms are layered, so that the beam meets more change
// upwards than sideways.
constexpr double farthestNode = 2.4;
std::array<QuadratureNode, 7> MakeLayerNodes()
{
  std::array<QuadratureNode, 7> nodes{};
  double sum = 0.0;
  for (std::size_t index = 0; index < nodes.size(); ++index)
  {
    const double position = farthestNode * (static_cast<double>(index) - 3.0) / 3.0;
    nodes[index] = {position, std::exp(-position * position / 2.0)};
    sum += nodes[index].weight;
  }
  for (QuadratureNode& node : nodes)
  {
    node.weight /= sum;
  }
  return nodes;
}
const std::array<QuadratureNode, 7> layerNodes = MakeLayerNodes();

} // namespace

BeamSampler::BeamSampler(const Position& antenna, double cutElevation, double farthestRange,
  const BeamSamplerOptions& options)
  : site(antenna)
  , sigma(options.beamWidth / std::sqrt(16.0 * std::log(2.0)))
  , farthest(farthestRange)
  , path(options.effectiveRadiusFactor, cutElevation - elevationMargin - farthestNode * sigma,
      cutElevation + elevationMargin + farthestNode * sigma, farthestRange)
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
  const double side = root3 * sigma / std::cos(elevation * degree);
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

Cylinder BeamSampler::Span(double nearest, double end) const
{
  constexpr double slack = 100.0; // m, for what curves between the ends
  const PlanePoint middle = this->Centre((nearest + end) / 2.0);
  const double stretch = StormPlane::EastwardScale(site.latitude + farthest / 111'000.0);
  const double width = root3 * sigma * degree * end;
  Cylinder bounds{
    middle.x, middle.y, std::max(stretch, 1.0) * ((end - nearest) / 2.0 + width) + slack, 0.0, 0.0};
  const double low = elevation - farthestNode * sigma;
  const double high = elevation + farthestNode * sigma;
  bounds.bottom =
    site.altitude - slack + std::min({path.At(nearest, low).height, path.At(end, low).height});
  bounds.top = site.altitude + slack + path.At(end, high).height;
  return bounds;
}

BeamSampler::GateTracks BeamSampler::TracksAt(double groundDistance) const
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

double BeamSampler::MeanStormZ(const StormSnapshot& snapshot, double range, double offset) const
{
  const double middle = path.At(range, elevation).groundDistance;
  const GateTracks straight = this->TracksAt(middle);
  double mean = 0.0;
  for (std::size_t up = 0; up < layerNodes.size(); ++up)
  {
    const double direction = elevation + layerNodes[up].position * sigma;
    const std::array<PathPoint, 2> ends = {
      path.At(range - offset, direction), path.At(range + offset, direction)};
    for (std::size_t side = 0; side < straight.size(); ++side)
    {
      // The two ranges take turns, like the colours of a chessboard.
      const PathPoint& point = ends[(up + side) % 2];
      const double forward = point.groundDistance - middle;
      const StraightTrack& track = straight[side];
      const PlanePoint place{track.start.x + forward * track.x, track.start.y + forward * track.y,
        point.height + site.altitude};
      mean += layerNodes[up].weight * smoothNodes[side].weight *
              ToZ(snapshot.Reflectivity(place, candidates));
    }
  }
  return mean;
}

double BeamSampler::MeanClearAirZ(const StormSnapshot& snapshot, double range) const
{
  double mean = 0.0;
  for (const QuadratureNode& up : smoothNodes)
  {
    const PathPoint point = path.At(range, elevation + up.position * sigma);
    mean += up.weight * ToZ(snapshot.Reflectivity(this->Place(tracks[1], point), candidates));
  }
  return mean;
}

void BeamSampler::SampleBlock(const StormSnapshot& snapshot, const GateLayout& layout, int first,
  int end, std::vector<double>& reflectivity)
{
  const double half = layout.gateSpacing / 2.0;
  const Cylinder reach =
    this->Span(std::max(layout.Range(first) - half, 0.0), layout.Range(end - 1) + half);
  snapshot.FindElements(reach, nearby, candidates);
  if (candidates.empty() && reach.bottom > StormSnapshot::ClearAirTop())
  {
    return;
  }
  for (int gate = first; gate < end; ++gate)
  {
    // The antenna itself is the nearest that a gate reaches.
    const double range = std::max(layout.Range(gate), half);
    const double z = candidates.empty() ? this->MeanClearAirZ(snapshot, range)
                                        : this->MeanStormZ(snapshot, range, half / root3);
    reflectivity[static_cast<std::size_t>(gate)] = z > 0.0 ? 10.0 * std::log10(z) : nothing;
  }
}

void BeamSampler::Sample(
  const StormSnapshot& snapshot, const GateLayout& layout, std::vector<double>& reflectivity)
{
  reflectivity.assign(static_cast<std::size_t>(layout.gates), nothing);
  const int partGates = std::max(1, static_cast<int>(partLength / layout.gateSpacing));
  const int blockGates = std::max(1, static_cast<int>(blockLength / layout.gateSpacing));
  for (int part = 0; part < layout.gates; part += partGates)
  {
    const int end = std::min(part + partGates, layout.gates);
    const Cylinder reach =
      this->Span(std::max(layout.Range(part) - layout.gateSpacing, 0.0), layout.Range(end));
    snapshot.FindElements(reach, nearby);
    if (nearby.empty() && reach.bottom > StormSnapshot::ClearAirTop())
    {
      continue;
    }
    for (int first = part; first < end; first += blockGates)
    {
      this->SampleBlock(snapshot, layout, first, std::min(first + blockGates, end), reflectivity);
    }
  }
}

} // namespace nexrad

// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "nexrad/Model/Site.h"
#include "nexrad/Simulation/StormPlane.h"

#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

namespace nexrad
{

/// A direction off the beam's middle, in standard deviations of the two-way pattern, and its
/// weight.
struct QuadratureNode
{
  double position;
  double weight;
};

constexpr double Root3 = 1.7320508075688772;

/// The Gauss-Hermite rule of three nodes: for what is smooth across the beam.
constexpr std::array<QuadratureNode, 3> SmoothNodes = {
  {{-Root3, 1.0 / 6.0}, {0.0, 2.0 / 3.0}, {Root3, 1.0 / 6.0}}};

/// How far LayerNodes reach.
constexpr double FarthestNode = 2.4;

/// Equal steps weighted with the pattern: storms are layered, so that the beam meets more change
/// upwards than sideways.
inline const std::array<QuadratureNode, 7>& LayerNodes()
{
  static const std::array<QuadratureNode, 7> layerNodes = []
  {
    std::array<QuadratureNode, 7> nodes{};
    double sum = 0.0;
    for (std::size_t index = 0; index < nodes.size(); ++index)
    {
      const double position = FarthestNode * (static_cast<double>(index) - 3.0) / 3.0;
      nodes[index] = {position, std::exp(-position * position / 2.0)};
      sum += nodes[index].weight;
    }
    for (QuadratureNode& node : nodes)
    {
      node.weight /= sum;
    }
    return nodes;
  }();
  return layerNodes;
}

/// A point of a simulated beam: height above the antenna and distance along the ground, m.
struct PathPoint
{
  double height = 0.0;
  double groundDistance = 0.0;
};

/// Rays traced step by step through a spherical atmosphere whose refractive index falls linearly in
/// its logarithm with height. The gradient is the one that an effective earth of k times the
/// radius stands for: (1/k − 1)/a, a = 6 371 000 m. It shares nothing with BeamModel, so that the
/// geometry of the gridding is not tested against itself.
class RefractedPath
{
public:
  /// Traces all elevations (degrees) in a span, up to a slant range in m.
  RefractedPath(double effectiveRadiusFactor, double lowestElevation, double highestElevation,
    double farthestRange);

  /// Interpolated; outside the span the nearest traced ray and range count. Errs by less than
  /// 0.1 m.
  PathPoint At(double range, double elevation) const;

private:
  double lowest;
  std::size_t steps;             // points of a traced ray
  std::vector<PathPoint> points; // one ray after another
  std::size_t rays;
};

/// What the sampler needs to know of a radar and its air.
struct BeamSamplerOptions
{
  double effectiveRadiusFactor = 4.0 / 3.0;
  double beamWidth = 0.95; ///< degrees, between half-power points of the one-way pattern
};

/// Where the beam of one radar runs in one cut: its middle and its sides in the storm day's plane.
class BeamTrace
{
public:
  /// `elevation` in degrees is the cut's; rays may lie up to 0.5° off it. `farthest` in m.
  BeamTrace(
    const Position& site, double elevation, double farthest, const BeamSamplerOptions& options);

  /// Points the antenna, in degrees.
  void Point(double azimuth, double elevation);

  double Azimuth() const { return azimuth; }
  double Elevation() const { return elevation; }
  /// Standard deviation of the two-way pattern, degrees: beamWidth/√(16 ln 2).
  double Sigma() const { return sigma; }
  double SiteAltitude() const { return site.altitude; }

  /// A point of the beam's middle plane, at a slant range in m and an elevation in degrees.
  PathPoint At(double range, double direction) const { return path.At(range, direction); }
  /// The same as a point of the storm day, at the ray's azimuth.
  PlanePoint Place(const PathPoint& point) const { return this->Place(tracks[1], point); }
  /// Middle of the beam at a slant range in m.
  PlanePoint Centre(double range) const { return this->Place(path.At(range, elevation)); }
  /// What the beam fills between two ranges in m.
  Cylinder Span(double nearest, double end) const;

  /// A track about one gate: a point, and the plane's change a metre onwards.
  struct StraightTrack
  {
    PlanePoint start;
    double x;
    double y;

    PlanePoint At(double forward, double height) const
    {
      return {start.x + forward * x, start.y + forward * y, height};
    }
  };
  /// Left of the beam, in its middle, right of it: the directions of SmoothNodes.
  using GateTracks = std::array<StraightTrack, 3>;
  GateTracks TracksAt(double groundDistance) const;

private:
  static constexpr int nodes = 5;
  // The plane's coordinates along a geodesic: Newton's differences at equal steps of distance.
  struct Track
  {
    std::array<double, nodes> x{};
    std::array<double, nodes> y{};
  };

  Position site;
  double sigma;
  double farthest;
  RefractedPath path;
  double azimuth = 0.0;
  double elevation = 0.0;        // of the ray
  std::array<Track, 3> tracks{}; // left of the beam, in its middle, right of it

  Track TraceGround(double bearing) const;
  PlanePoint Place(const Track& track, const PathPoint& point) const;
};

} // namespace nexrad

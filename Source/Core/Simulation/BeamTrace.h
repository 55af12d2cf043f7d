// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "nexrad/Model/Site.h"
#include "nexrad/Simulation/RefractedPath.h"
#include "nexrad/Simulation/StormPlane.h"

#include <array>

namespace nexrad
{

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

// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "nexrad/Model/Site.h"
#include "nexrad/Simulation/RefractedPath.h"
#include "nexrad/Simulation/ScanStrategy.h"
#include "nexrad/Simulation/StormSnapshot.h"

#include <array>
#include <vector>

namespace nexrad
{

/// What the sampler needs to know of a radar and its air.
struct BeamSamplerOptions
{
  double effectiveRadiusFactor = 4.0 / 3.0;
  double beamWidth = 0.95; ///< degrees, between half-power points of the one-way pattern
};

/// Averages the storm field over the beam, gate by gate, in one cut of one radar.
///
/// A gate is the mean of Z (linear, mm⁶/m³) weighted with the two-way pattern of a Gaussian beam,
/// of standard deviation beamWidth/√(16 ln 2), over seven elevations, three azimuths and the gate's
/// two Gauss points. Where there is clear-air return alone, three elevations do.
class BeamSampler
{
public:
  /// `elevation` in degrees is the cut's; rays may lie up to 0.5° off it. `farthest` in m.
  BeamSampler(
    const Position& site, double elevation, double farthest, const BeamSamplerOptions& options);

  /// Points the antenna, in degrees.
  void Point(double azimuth, double elevation);

  /// Reflectivity in dBZ of each gate; -infinity where the beam meets no echo.
  void Sample(
    const StormSnapshot& snapshot, const GateLayout& layout, std::vector<double>& reflectivity);

  /// Middle of the beam at a slant range in m.
  PlanePoint Centre(double range) const;

private:
  static constexpr int nodes = 5;
  // The plane's coordinates along a geodesic: Newton's differences at equal steps of distance.
  struct Track
  {
    std::array<double, nodes> x{};
    std::array<double, nodes> y{};
  };
  // A track about one gate: a point, and the plane's change a metre onwards.
  struct StraightTrack
  {
    PlanePoint start;
    double x;
    double y;
  };
  using GateTracks = std::array<StraightTrack, 3>;

  Position site;
  double sigma; // degrees, of the two-way pattern
  double farthest;
  RefractedPath path;
  double elevation = 0.0;        // degrees, of the ray
  std::array<Track, 3> tracks{}; // left of the beam, in its middle, right of it
  std::vector<int> nearby;       // elements in reach of a part of the ray
  std::vector<int> candidates;   // elements in reach of a few gates

  Track TraceGround(double azimuth) const;
  PlanePoint Place(const Track& track, const PathPoint& point) const;
  /// What the beam fills between two ranges in m.
  Cylinder Span(double nearest, double end) const;
  /// The gates [first, end) of a layout, which the elements of `nearby` can reach.
  void SampleBlock(const StormSnapshot& snapshot, const GateLayout& layout, int first, int end,
    std::vector<double>& reflectivity);
  GateTracks TracksAt(double groundDistance) const;
  /// Mean of Z over the beam and a gate: `offset` in m is that of the Gauss points from its middle.
  double MeanStormZ(const StormSnapshot& snapshot, double range, double offset) const;
  double MeanClearAirZ(const StormSnapshot& snapshot, double range) const;
};

} // namespace nexrad

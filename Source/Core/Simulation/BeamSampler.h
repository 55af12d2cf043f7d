// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "nexrad/Simulation/BeamTrace.h"
#include "nexrad/Simulation/ScanStrategy.h"
#include "nexrad/Simulation/StormSnapshot.h"

#include <array>
#include <vector>

namespace nexrad
{

/// How the echo of a gate is spread over the beam.
struct EchoSpread
{
  /// Shares of the mean Z, in any unit: of LayerNodes upwards, for each of SmoothNodes sideways.
  /// Only where `bySide` is set.
  std::array<std::array<float, 3>, 7> shares{};
  bool bySide = false; ///< false: the echo is level, and the beam's sides are alike
  float lift = 0.0F;   ///< mean elevation above the beam's middle, standard deviations of the
                       ///< pattern
  float width = 1.0F;  ///< standard deviation of the elevation, in the same unit
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
    const Position& site, double elevation, double farthest, const BeamSamplerOptions& options)
    : trace(site, elevation, farthest, options)
  {
  }

  /// Points the antenna, in degrees.
  void Point(double azimuth, double elevation) { trace.Point(azimuth, elevation); }

  /// Reflectivity in dBZ of each gate; -infinity where the beam meets no echo. Sets Spreads.
  void Sample(
    const StormSnapshot& snapshot, const GateLayout& layout, std::vector<double>& reflectivity);

  /// Of the gates of the last Sample; without meaning where the beam meets no echo.
  const std::vector<EchoSpread>& Spreads() const { return spreads; }

  /// Where the beam runs.
  const BeamTrace& Trace() const { return trace; }

private:
  BeamTrace trace;
  std::vector<EchoSpread> spreads;
  std::vector<int> nearby;     // elements in reach of a part of the ray
  std::vector<int> candidates; // elements in reach of a few gates

  /// The gates [first, end) of a layout, which the elements of `nearby` can reach.
  void SampleBlock(const StormSnapshot& snapshot, const GateLayout& layout, int first, int end,
    std::vector<double>& reflectivity);
  /// Mean of Z over the beam and a gate: `offset` in m is that of the Gauss points from its middle.
  double MeanStormZ(
    const StormSnapshot& snapshot, double range, double offset, EchoSpread& spread) const;
  double MeanClearAirZ(const StormSnapshot& snapshot, double range, EchoSpread& spread) const;
};

/// The radial velocities that the beam meets in a gate, weighted with Z and the beam's pattern,
/// m/s.
struct BeamVelocity
{
  double mean = 0.0;      ///< positive away from the radar; not folded
  double deviation = 0.0; ///< standard deviation: the shear within the beam
};

/// Radial velocities along one ray: the wind's component along the beam, u·sin φ·cos θ +
/// w·cos φ·cos θ with the azimuth φ and the elevation θ of the direction at the antenna,
/// positive away from the radar.
///
/// Near the axis of a vortex (one and a half core radii and less) a gate is the mean over the
/// points of the beam that BeamSampler uses, weighted with their Z. Elsewhere the wind changes so
/// evenly that its value where the echo of the gate is centred stands for the mean.
class VelocitySampler
{
public:
  /// For the ray that the trace points along. Both must outlive the sampler.
  VelocitySampler(const BeamTrace& trace, const StormSnapshot& snapshot);

  /// A gate: its range in m, and how its echo is spread over the beam.
  BeamVelocity Sample(double range, const EchoSpread& echo);

  /// The component of a motion along the middle of the beam, m/s.
  double Along(const WindVector& motion) const
  {
    return levels[3] * (headings[1].east * motion.east + headings[1].north * motion.north);
  }

private:
  // The horizontal direction of a side of the beam, east and north.
  struct Heading
  {
    double east;
    double north;
  };

  const BeamTrace& beam;
  const StormSnapshot& storms;
  std::array<Heading, 3> headings{}; // left of the beam, in its middle, right of it
  std::array<double, 7> levels{};    // cosines of the elevations of LayerNodes
  int block = -1;                    // that `vortices` are of
  int part = -1;                     // that `nearby` is of
  std::vector<int> nearby;           // vortices in reach of a part of the ray
  bool isClose = false;              // the beam meets a vortex's core or what is next to it
  std::vector<int> vortices;         // in reach

  void EnterBlock(int number);
  BeamVelocity AtCentre(double range, const EchoSpread& echo) const;
  /// At the three sides of the beam, at one height.
  std::array<WindVector, 3> WindsAcross(
    const std::array<PlanePoint, 3>& places, double height) const;
  BeamVelocity OverBeam(double range, const EchoSpread& echo) const;
};

} // namespace nexrad

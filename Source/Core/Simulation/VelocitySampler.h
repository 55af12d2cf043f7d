// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "nexrad/Simulation/BeamSampler.h"

#include <vector>

namespace nexrad
{

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
/// Near the axis of a vortex (twice its core radius and less) a gate is the mean over the points of
/// the beam that BeamSampler uses, weighted with their Z. Elsewhere the wind changes so evenly that
/// its value where the echo of the gate is centred stands for the mean.
class VelocitySampler
{
public:
  /// For the ray that the trace points along. Both must outlive the sampler.
  VelocitySampler(const BeamTrace& trace, const StormSnapshot& snapshot);

  /// A gate: its range in m, and how its echo is spread over the beam.
  BeamVelocity Sample(double range, const EchoSpread& echo);

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
  bool isClose = false;              // the beam meets a vortex's core or what is next to it
  std::vector<int> vortices;         // in reach

  void EnterBlock(int number);
  BeamVelocity AtCentre(double range, const EchoSpread& echo) const;
  BeamVelocity OverBeam(double range, const EchoSpread& echo) const;
};

} // namespace nexrad

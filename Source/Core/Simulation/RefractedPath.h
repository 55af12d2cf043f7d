// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <vector>

namespace nexrad
{

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

} // namespace nexrad

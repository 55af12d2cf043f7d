// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "nexrad/Simulation/Basis/StormPlane.h"
#include "nexrad/Simulation/Wind/MeanWind.h"

namespace nexrad
{

/// A speed that is greatest at one height and falls to zero a depth above and below it, as
/// (1 − ((z − height)/depth)²)².
struct FlowLayer
{
  double speed = 0.0;  ///< m/s, at `height`
  double height = 0.0; ///< m above mean sea level
  double depth = 1.0;  ///< m

  double At(double z) const
  {
    const double distance = (z - height) / depth;
    const double left = 1.0 - distance * distance;
    return left > 0.0 ? speed * left * left : 0.0;
  }
  /// False when no height of a span has any speed.
  bool Touches(double bottom, double top) const
  {
    return speed > 0.0 && bottom < height + depth && top > height - depth;
  }
};

/// What a storm adds to the wind about an axis that leans with the storm: air that turns about the
/// axis (a mesocyclone, anticlockwise), air that flows towards it (the convergence below an
/// updraft) and air that flows away from it (the divergence at the updraft's top). The speed
/// changes with the distance r from the axis as in Rankine's vortex: in the core, r ≤ R, it is
/// V·r/R (solid-body rotation, uniform divergence); outside it falls as V·R/r, less what is left of
/// that at Reach, so that it ends there without a jump.
struct StormVortex
{
  double x = 0.0; ///< m in the plane, axis at `level`
  double y = 0.0;
  double level = 0.0; ///< m above mean sea level
  double tiltX = 0.0; ///< m of shift of the axis a metre of height
  double tiltY = 0.0;
  double coreRadius = 3000.0; ///< m, at `level`
  double widening = 0.0;      ///< m of radius a metre of height
  FlowLayer rotation;         ///< along the tangent, at the edge of the core
  FlowLayer inflow;           ///< towards the axis, at the edge of the core
  FlowLayer outflow;          ///< away from the axis, at the edge of the core

  /// m from the axis; beyond it the storm adds nothing.
  static constexpr double Reach = 25'000.0;

  /// Radius of the core at a height, m.
  double RadiusAt(double z) const;
  /// The middle of the axis at a height.
  PlanePoint AxisAt(double z) const
  {
    return {x + tiltX * (z - level), y + tiltY * (z - level), z};
  }
  /// Adds the storm's part to the wind at a point.
  void AddTo(WindVector& wind, const PlanePoint& point) const;
  /// Whether some point of a cylinder lies within a distance in m of the axis, at a height at which
  /// the air moves.
  bool Touches(const Cylinder& cylinder, double distance) const;
};

} // namespace nexrad

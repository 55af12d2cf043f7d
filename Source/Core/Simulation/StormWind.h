// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "nexrad/Simulation/StormPlane.h"

#include <cmath>
#include <vector>

namespace nexrad
{

/// Motion of the air, m/s to the east and to the north. The simulated air does not rise or sink.
struct WindVector
{
  double east = 0.0;
  double north = 0.0;
};

/// The mean wind at one height.
struct WindLevel
{
  double height = 0.0;    ///< m above mean sea level, a multiple of 500
  double direction = 0.0; ///< degrees clockwise from north, where the wind comes from
  double speed = 0.0;     ///< m/s
};

/// The levels that define the mean wind of the synthetic day, from the lowest up. The wind veers
/// and strengthens with height, as in the environment of supercells (Weisman and Klemp 1984): the
/// difference between 0 and 6 km is 32 m/s.
const std::vector<WindLevel>& MeanWindLevels();

/// The mean wind at a height in m above mean sea level: linear in both components between the
/// levels; below the lowest and above the highest level it is that level's.
WindVector MeanWind(double height);

/// A speed that is greatest at one height and falls to zero a depth above and below it, as
/// (1 − ((z − height)/depth)²)².
struct FlowLayer
{
  double speed = 0.0;  ///< m/s, at `height`
  double height = 0.0; ///< m above mean sea level
  double depth = 1.0;  ///< m

  double At(double z) const
  {
    if (!(speed > 0.0))
    {
      return 0.0;
    }
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

/// The wind of a StormVortex at one height.
class VortexSlice
{
public:
  /// The axis (m in the plane), the radius of the core (m), and the speeds at its edge in m/s:
  /// along the tangent, anticlockwise, and away from the axis.
  VortexSlice(const PlanePoint& axis, double coreRadius, double turning, double leaving);

  /// True where the air is not moved at all.
  bool IsStill() const { return turning == 0.0 && leaving == 0.0; }

  /// Adds the storm's part to the wind at a place of the plane.
  void AddTo(WindVector& wind, double placeX, double placeY) const
  {
    const double east = placeX - x;
    const double north = placeY - y;
    const double squared = east * east + north * north;
    if (squared >= reachSquared)
    {
      return;
    }
    // Of the distance from the axis: in the core, and outside it.
    const double perMetre =
      squared <= coreSquared ? inCore : outside / squared - rest / std::sqrt(squared);
    wind.east += perMetre * (leaving * east - turning * north);
    wind.north += perMetre * (leaving * north + turning * east);
  }

private:
  double x;
  double y;
  double turning;
  double leaving;
  double reachSquared;
  double coreSquared;
  double inCore;  // 1/R
  double outside; // R/(1 − R/Reach)
  double rest;    // (R/Reach)/(1 − R/Reach)
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
  /// What it adds at a height.
  VortexSlice At(double z) const;
  /// Adds the storm's part to the wind at a point.
  void AddTo(WindVector& wind, const PlanePoint& point) const
  {
    this->At(point.z).AddTo(wind, point.x, point.y);
  }
  /// Whether some point of a cylinder lies within a distance in m of the axis, at a height at which
  /// the air moves.
  bool Touches(const Cylinder& cylinder, double distance) const;
};

} // namespace nexrad

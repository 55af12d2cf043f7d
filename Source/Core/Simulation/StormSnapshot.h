// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "nexrad/Simulation/StormElement.h"

#include <array>
#include <vector>

namespace nexrad
{

/// The plane of the storm day: equirectangular about 39° N 91.5° W on a sphere of 6 371 000 m,
/// x = R·cos 39°·Δlongitude, y = R·Δlatitude. A map of the field alone: radars see it through
/// geodesics on WGS84.
struct StormPlane
{
  static PlanePoint FromGeographic(double longitude, double latitude, double height);
  /// m of plane a metre of true distance eastwards, at a latitude in degrees.
  static double EastwardScale(double latitude);
};

/// A mesocyclone: rotation about an upright axis, anticlockwise, fastest at `radius`.
struct StormVortex
{
  double x = 0.0; ///< m in the plane
  double y = 0.0;
  double radius = 3000.0; ///< m
  double speed = 0.0;     ///< m/s at `radius`
};

/// Motion of the air, m/s to the east and to the north.
struct WindVector
{
  double east = 0.0;
  double north = 0.0;
};

/// The storm field at one instant.
class StormSnapshot
{
public:
  StormSnapshot() = default;
  /// `seconds` after midnight UTC: the texture drifts with the storms, and repeats after a day.
  StormSnapshot(
    std::vector<StormElement> elements, std::vector<StormVortex> vortices, double seconds);

  /// Numbers of the elements that can hold echo in a cylinder.
  void FindElements(const Cylinder& within, std::vector<int>& found) const;
  /// Those of them that are among the elements found in a larger cylinder.
  void FindElements(
    const Cylinder& within, const std::vector<int>& among, std::vector<int>& found) const;

  /// dBZ; -infinity where there is no echo.
  double Reflectivity(const PlanePoint& point) const;
  /// The same, where only these elements (of FindElements) can reach.
  double Reflectivity(const PlanePoint& point, const std::vector<int>& candidates) const;

  /// Wind of the environment, and of the mesocyclones in it.
  WindVector Wind(const PlanePoint& point) const;

  /// Height above which there is no clear-air return, m.
  static double ClearAirTop();
  /// Strongest clear-air return, dBZ: always below 0.
  static double ClearAirMaximum();

private:
  std::vector<StormElement> elements;
  std::vector<ElementBounds> bounds;
  std::vector<StormVortex> vortices;
  std::array<double, 3> texturePhases{}; // turns

  double Texture(const PlanePoint& point) const;
};

} // namespace nexrad

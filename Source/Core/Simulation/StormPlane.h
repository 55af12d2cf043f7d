// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "nexrad/Geometry/Angles.h"

#include <cmath>

namespace nexrad
{

/// A point of the storm day's local plane: m east and north of its reference point (StormPlane),
/// m above mean sea level.
struct PlanePoint
{
  double x = 0.0;
  double y = 0.0;
  double z = 0.0;
};

/// Height of the melting level of the synthetic day, m above mean sea level.
constexpr double MeltingLevel = 2'900.0;

/// An upright cylinder, m in the plane and m above mean sea level.
struct Cylinder
{
  double x, y, radius;
  double bottom, top;
};

/// The plane of the storm day: equirectangular about 39° N 91.5° W on a sphere of 6 371 000 m,
/// x = R·cos 39°·Δlongitude, y = R·Δlatitude. A map of the field alone: radars see it through
/// geodesics on WGS84.
struct StormPlane
{
  static PlanePoint FromGeographic(double longitude, double latitude, double height)
  {
    static const double eastScale = std::cos(referenceLatitude * RadiansPerDegree);
    return {sphereRadius * eastScale * (longitude - referenceLongitude) * RadiansPerDegree,
      sphereRadius * (latitude - referenceLatitude) * RadiansPerDegree, height};
  }

  /// m of plane a metre of true distance eastwards, at a latitude in degrees.
  static double EastwardScale(double latitude)
  {
    return std::cos(referenceLatitude * RadiansPerDegree) / std::cos(latitude * RadiansPerDegree);
  }

private:
  static constexpr double sphereRadius = 6'371'000.0; // m
  static constexpr double referenceLatitude = 39.0;   // degrees
  static constexpr double referenceLongitude = -91.5; // degrees
};

} // namespace nexrad

// SPDX-License-Identifier: BSD-3-Clause
#include "nexrad/Simulation/StormPlane.h"

#include "nexrad/Geometry/Angles.h"

#include <cmath>

namespace nexrad
{

namespace
{

constexpr double sphereRadius = 6'371'000.0; // m
constexpr double referenceLatitude = 39.0;   // degrees
constexpr double referenceLongitude = -91.5; // degrees

} // namespace

PlanePoint StormPlane::FromGeographic(double longitude, double latitude, double height)
{
  static const double eastScale = std::cos(referenceLatitude * RadiansPerDegree);
  return {sphereRadius * eastScale * (longitude - referenceLongitude) * RadiansPerDegree,
    sphereRadius * (latitude - referenceLatitude) * RadiansPerDegree, height};
}

double StormPlane::EastwardScale(double latitude)
{
  return std::cos(referenceLatitude * RadiansPerDegree) / std::cos(latitude * RadiansPerDegree);
}

} // namespace nexrad

// SPDX-License-Identifier: BSD-3-Clause
#include "nexrad/Simulation/Basis/StormPlane.h"

#include <cmath>

namespace nexrad
{

namespace
{

constexpr double degree = 3.14159265358979323846 / 180.0;
constexpr double sphereRadius = 6'371'000.0; // m
constexpr double referenceLatitude = 39.0;   // degrees
constexpr double referenceLongitude = -91.5; // degrees

} // namespace

PlanePoint StormPlane::FromGeographic(double longitude, double latitude, double height)
{
  static const double eastScale = std::cos(referenceLatitude * degree);
  return {sphereRadius * eastScale * (longitude - referenceLongitude) * degree,
    sphereRadius * (latitude - referenceLatitude) * degree, height};
}

double StormPlane::EastwardScale(double latitude)
{
  return std::cos(referenceLatitude * degree) / std::cos(latitude * degree);
}

} // namespace nexrad

// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>

namespace nexrad
{

constexpr double Pi = 3.14159265358979323846;
constexpr double RadiansPerDegree = Pi / 180.0;
/// Radius of a sphere that stands for the earth, m.
constexpr double EarthRadius = 6'371'000.0;
/// Length of a degree of latitude on it, m.
constexpr double MetresPerDegree = EarthRadius * RadiansPerDegree;

/// A direction in degrees as 0 to below 360.
inline double ToFullTurn(double degrees)
{
  const double turned = std::fmod(degrees, 360.0);
  return turned < 0.0 ? turned + 360.0 : turned;
}

/// Angle between two directions of 0 to 360 degrees: 0…180.
inline double AngleBetween(double one, double other)
{
  const double apart = std::abs(one - other);
  return apart <= 180.0 ? apart : 360.0 - apart;
}

/// Smallest turn from one direction to another, both in degrees: −180…180, clockwise positive.
inline double AngleDifference(double from, double to)
{
  return std::remainder(to - from, 360.0);
}

} // namespace nexrad

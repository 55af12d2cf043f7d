// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>

namespace nexrad
{

constexpr double Pi = 3.14159265358979323846;
constexpr double RadiansPerDegree = Pi / 180.0;
/// Length of a degree of latitude on a sphere of 6371 km, m.
constexpr double MetresPerDegree = 6'371'000.0 * RadiansPerDegree;

/// Smallest turn from one direction to another, both in degrees: −180…180, clockwise positive.
inline double AngleDifference(double from, double to)
{
  return std::remainder(to - from, 360.0);
}

} // namespace nexrad

// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "nexrad/Geometry/Angles.h"
#include "nexrad/Velocity/WindProfile.h"

#include <cmath>

namespace nexrad::testing
{

/// The wind of given speed, m/s, from a direction, degrees clockwise from north.
inline Wind WindFrom(double direction, double speed)
{
  return {-speed * std::sin(direction * RadiansPerDegree),
    -speed * std::cos(direction * RadiansPerDegree)};
}

} // namespace nexrad::testing

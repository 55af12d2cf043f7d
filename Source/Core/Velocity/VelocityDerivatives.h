// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "nexrad/Velocity/VelocityVolume.h"
#include "nexrad/Velocity/WindProfile.h"

#include <vector>

namespace nexrad
{

/// Makes velocities relative to a storm (Formulas P5): takes the radial component of the storm's
/// motion, towards the east and the north, m/s, from each of them.
void SubtractMotion(VelocitySweep& sweep, const Wind& motion);

/// The azimuthal shear of a sweep of dealiased velocities, per second, rays × gates (Formulas V5):
/// the change of the radial velocity along the azimuth, clockwise. It is positive where air turns
/// anticlockwise; solid-body rotation with the angular velocity ω has the shear ω. The slope of a
/// plane fitted by least squares to a window of 2500 m along the azimuth and 750 m along the ray,
/// with Cressman weights of radius 2500 m; the window has at least the rays and gates beside a
/// gate. NaN for gates without a velocity, and where a third of the window or more has none.
std::vector<float> AzimuthalShear(const VelocitySweep& sweep);

/// The same along the ray: the radial divergence, per second, positive where air flows apart, in a
/// window of 750 m along the azimuth and 1500 m along the ray.
std::vector<float> RadialDivergence(const VelocitySweep& sweep);

} // namespace nexrad

// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "nexrad/Velocity/VelocityVolume.h"
#include "nexrad/Velocity/WindProfile.h"

#include <optional>

namespace nexrad
{

/// The height over the radar up to which the wind counts, m.
constexpr double SteeringDepth = 6'000.0;

/// The motion of storms, m/s, as far as one volume of dealiased velocities tells it: the mean of
/// the wind from the ground to SteeringDepth over the radar, of the volume's wind profile
/// (FitWindProfile), every 100 m of height counting alike where the profile has a wind
/// (WindProfile::At). Empty where it has one at less than a third of these heights.
std::optional<Wind> EstimateStormMotion(const VelocityVolume& volume);

} // namespace nexrad

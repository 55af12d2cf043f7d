// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "nexrad/Velocity/VelocityVolume.h"
#include "nexrad/Velocity/WindProfile.h"

#include <optional>

namespace nexrad
{

/// The height over the radar up to which the wind counts, m.
constexpr double SteeringDepth = 6'000.0;

/// Ground distance up to which velocities count at heights at which those nearer tell no wind, m.
constexpr double FarthestSteeringWind = 120'000.0;

/// The motion of storms, m/s, as far as one volume of dealiased velocities tells it: the mean of
/// the wind from the antenna to SteeringDepth above it, of the volume's wind profile
/// (FitWindProfile, up to 60 km from the radar; at heights at which that has no wind, up to
/// FarthestSteeringWind), every 100 m of height that has a wind counting alike. Where echo is
/// shallow that is the mean over the depth of the echo. Empty where less than 2 km of the heights
/// have a wind.
std::optional<Wind> EstimateStormMotion(const VelocityVolume& volume);

} // namespace nexrad

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
/// FarthestSteeringWind), every 100 m of height counting alike. Empty where less than three
/// quarters of these heights have a wind: the wind turns and grows with height, so that the mean of
/// a part of them is another one.
std::optional<Wind> EstimateStormMotion(const VelocityVolume& volume);

} // namespace nexrad

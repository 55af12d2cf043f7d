// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "nexrad/Model/RadarVolume.h"
#include "nexrad/Velocity/VelocityVolume.h"

#include <string>

namespace nexrad::testing
{

/// A SYNTHETIC volume, and the velocities of its gates.
struct SimulatedVelocities
{
  RadarVolume volume;
  VelocityVolume folded; ///< as the radar measures them
  VelocityVolume truth;  ///< the same with noise, and not folded
};

/// Scans the synthetic storm day at 18:30 by a coverage pattern.
SimulatedVelocities SimulateVelocities(
  const std::string& site, int pattern, bool superResolution = false);

/// Polar data of VEL that hold velocities as they are, with the rays of `folded`, which is
/// MakePolarVolume of the same volume.
PolarVolume PolarVelocities(const VelocityVolume& velocities, PolarVolume folded);

} // namespace nexrad::testing

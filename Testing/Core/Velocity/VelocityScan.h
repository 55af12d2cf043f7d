// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Scans/WindFrom.h"
#include "nexrad/Velocity/VelocityVolume.h"

#include <cstddef>
#include <functional>
#include <vector>

namespace nexrad::testing
{

/// A place over a radar, m east and north of it along the ground, and m above the antenna.
struct PlaceOverRadar
{
  double east;
  double north;
  double height;
};

/// How a radar scans a wind that is known everywhere.
struct VelocityScan
{
  std::vector<double> elevations = {0.5, 1.5, 2.4, 3.4, 4.3, 6.0, 9.9, 14.6, 19.5}; ///< degrees
  std::size_t rays = 360;
  std::size_t gates = 400;
  double gateSpacing = 250.0; ///< m
  double noise = 1.0;         ///< m/s, standard deviation
  std::function<Wind(const PlaceOverRadar&)> wind;
  /// Where there is echo; everywhere when empty.
  std::function<bool(const PlaceOverRadar&)> echo;
};

/// The velocities of the scan, not folded: the radial component of the wind, and noise that is the
/// same in each run. The rays have no Nyquist velocity yet (FoldVelocities sets it).
VelocityVolume ScanVelocities(const VelocityScan& scan);

/// Folds the velocities of a sweep into −nyquist…nyquist, m/s, as a radar of that Nyquist velocity
/// would measure them; each ray then has that Nyquist velocity.
void FoldVelocities(VelocitySweep& sweep, float nyquist);

/// The same volume with velocities folded at one Nyquist velocity, m/s.
VelocityVolume FoldedAt(VelocityVolume volume, float nyquist);

} // namespace nexrad::testing

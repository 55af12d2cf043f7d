// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "nexrad/Velocity/VelocityVolume.h"
#include "nexrad/Velocity/WindProfile.h"

namespace nexrad
{

/// Which gates a wind profile is fitted to.
struct ProfileOptions
{
  double layerDepth = 300.0;  ///< m of height that one level stands for; above 0
  double nearest = 3'000.0;   ///< m of ground distance; closer in, side lobes see the ground
  double farthest = 60'000.0; ///< m of ground distance; above `nearest`
};

/// The wind profile of a volume whose velocities are dealiased (Formulas V3): the velocity-azimuth
/// display. To the gates of all sweeps within each layer of height,
/// v = a0 + cos θ·(u·sin φ + w·cos φ) is fitted by least squares, with the azimuth φ and the
/// elevation θ; (u, w) is the wind towards the east and the north. The fit is made three times; in
/// the second and the third, gates that are farther from the fit before than twice its root mean
/// square are left out.
///
/// A layer has no level when fewer than half of the twelve sectors of 30° have 10 gates, when the
/// root mean square is above 5 m/s, or when a0 is farther from 0 than 7 m/s: then the wind is not
/// the same in all directions (the weather service's algorithm has the like limits). Heights are
/// the middles of the layers, above the antenna. Throws Error for options out of their range.
WindProfile FitWindProfile(const VelocityVolume& volume, const ProfileOptions& options = {});

} // namespace nexrad

// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "nexrad/Velocity/VelocityVolume.h"

#include <cmath>
#include <cstddef>
#include <optional>
#include <vector>

namespace nexrad
{

/// The horizontal wind, m/s.
struct Wind
{
  double east = 0.0;  ///< towards the east
  double north = 0.0; ///< towards the north

  double Speed() const { return std::hypot(east, north); }
  /// The direction that the wind comes from, degrees clockwise from north, 0…360.
  double Direction() const;
};

/// The wind at one height over a radar.
struct ProfileLevel
{
  double height = 0.0; ///< m above the antenna
  Wind wind;
  double rms = 0.0;      ///< m/s, root mean square of measured less fitted velocity
  std::size_t gates = 0; ///< that it was fitted to
};

/// The mean wind over a radar at several heights.
struct WindProfile
{
  std::vector<ProfileLevel> levels; ///< by ascending height

  /// The wind at a height, m above the antenna: linear between levels up to 2000 m apart; that of
  /// the nearest level up to `reach` m beyond one. Empty elsewhere.
  std::optional<Wind> At(double height, double reach = 1000.0) const;
  /// How far a height is from the nearest level, m; infinity without levels.
  double DistanceTo(double height) const;
};

/// Which gates a wind profile is fitted to.
struct ProfileOptions
{
  double layerDepth = 300.0;  ///< m of height that one level stands for; at least 10
  double farthest = 60'000.0; ///< m of ground distance; above 3 km, from which on gates count
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
/// the middles of the layers, above the antenna.
WindProfile FitWindProfile(const VelocityVolume& volume, const ProfileOptions& options = {});

} // namespace nexrad

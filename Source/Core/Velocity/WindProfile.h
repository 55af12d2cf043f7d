// SPDX-License-Identifier: BSD-3-Clause
#pragma once

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

  double Speed() const;
  /// The direction that the wind comes from, degrees clockwise from north, 0…360.
  double Direction() const;
};

/// The wind of given speed, m/s, from a direction, degrees clockwise from north.
Wind WindFrom(double direction, double speed);

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

} // namespace nexrad

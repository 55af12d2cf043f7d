// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

namespace nexrad
{

/// Motion of the air, m/s to the east and to the north. The simulated air does not rise or sink.
struct WindVector
{
  double east = 0.0;
  double north = 0.0;
};

/// The mean wind at one height.
struct WindLevel
{
  double height = 0.0;    ///< m above mean sea level, a multiple of 500
  double direction = 0.0; ///< degrees clockwise from north, where the wind comes from
  double speed = 0.0;     ///< m/s
};

/// The levels that define the mean wind of the synthetic day, from the lowest up. The wind veers
/// and strengthens with height, as in the environment of supercells (Weisman and Klemp 1984): the
/// difference between 0 and 6 km is 32 m/s.
const std::vector<WindLevel>& MeanWindLevels();

/// The mean wind at a height in m above mean sea level: linear in both components between the
/// levels; below the lowest and above the highest level it is that level's.
WindVector MeanWind(double height);

} // namespace nexrad

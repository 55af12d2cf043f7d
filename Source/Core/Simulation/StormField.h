// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "nexrad/Model/Time.h"
#include "nexrad/Simulation/StormLife.h"
#include "nexrad/Simulation/StormSnapshot.h"

#include <cstdint>
#include <vector>

namespace nexrad
{

/// All storms of a day. Their times and places are spread evenly, so that the activity is much the
/// same whatever the seed.
std::vector<StormLife> MakeStormDay(std::uint32_t seed);

/// The synthetic storm day: an analytic reflectivity field of several supercells that are born,
/// move, grow and decay over Missouri and Illinois on 2006-03-12, with weaker cells and rain areas
/// between them. Activity is greatest from 18:00 to midnight UTC; other dates have the same day. A
/// closed form, so that every stage can be held against the truth anywhere at any time. All data
/// made from it are SYNTHETIC.
///
/// The field is defined in dBZ; where pieces of storms overlap the strongest counts. Near the
/// ground there is a clear-air return everywhere, always below 0 dBZ. Documentation/Developer/
/// simulation.md describes the storms.
class StormField
{
public:
  /// The day depends on the seed alone.
  explicit StormField(std::uint32_t seed = 1);

  /// Reflectivity in dBZ at a point; -infinity where there is no echo at all. Height in m above
  /// mean sea level.
  double Reflectivity(double longitude, double latitude, double height, Time time) const;

  /// The field at one instant: the quick way to many points.
  StormSnapshot At(Time time) const;

private:
  std::vector<StormLife> storms;
};

} // namespace nexrad

// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "nexrad/Model/Time.h"
#include "nexrad/Simulation/StormSnapshot.h"

#include <cstdint>
#include <vector>

namespace nexrad
{

enum class StormKind
{
  Supercell,
  Cell,    ///< an ordinary shower or thunderstorm
  RainArea ///< stratiform rain
};

/// One storm from birth to death: it moves straight, and its strength follows its age.
struct StormLife
{
  StormKind kind = StormKind::Cell;
  double middleTime = 0.0;  ///< s after midnight UTC, half-way through its life
  double lifetime = 3600.0; ///< s
  double x = 0.0;           ///< m in the plane, at middleTime
  double y = 0.0;
  double east = 0.0; ///< m/s
  double north = 0.0;
  double peak = 50.0;   ///< dBZ at full strength
  double size = 1.0;    ///< factor of all lengths
  double top = 12000.0; ///< m above mean sea level
  // What makes one supercell unlike another.
  double downshear = 1.117;    ///< rad, bearing along which its anvil stretches and its tower leans
  double anvilLength = 1.0;    ///< factor
  double trailingExtent = 1.0; ///< factor of the rain area behind it
};

/// Adds what a storm consists of at an instant (s after midnight UTC; the day repeats).
void AddElements(const StormLife& storm, double seconds, std::vector<StormElement>& elements,
  std::vector<StormVortex>& vortices);

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

  /// The field at one instant.
  StormSnapshot At(Time time) const;

private:
  std::vector<StormLife> storms;
};

} // namespace nexrad

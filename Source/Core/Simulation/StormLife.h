// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "nexrad/Simulation/StormSnapshot.h"

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

} // namespace nexrad

// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "nexrad/Level2/Assembly/ArrivedRay.h"

#include <cstddef>
#include <string>
#include <vector>

namespace nexrad
{

/// Rays that one turn of the antenna gave, and how they end.
struct ArrivedSweep
{
  /// Number of the cut in the coverage pattern, from 1.
  int ElevationNumber() const { return rays.front()->ray.elevationNumber; }

  RayList rays;           ///< never empty
  double turned = 0.0;    ///< degrees from the first to the last ray
  bool cutOff = false;    ///< no radial ends it, and it is less than a full turn
  bool restarted = false; ///< cut off, and the next sweep is the same cut from its start
};

/// Makes sweeps of rays in the order scanned. A sweep begins where the cut changes or starts again,
/// or after 400 degrees. At most 2000 sweeps are made; the rest is left, and reported. Rays that
/// are missing in a sweep are reported, and where a sweep is scanned again a note is made.
std::vector<ArrivedSweep> BuildSweeps(
  const RayList& rays, const ArrivedDamage& report, std::vector<std::string>& notes);

/// "sweep 2 (elevation number 3)".
std::string NameOfSweep(std::size_t index, const ArrivedSweep& sweep);

} // namespace nexrad

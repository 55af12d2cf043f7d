// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "nexrad/Model/RadarVolume.h"

#include <cstddef>

namespace nexrad
{

/// What the gates of one moment in one sweep hold. Counts are of gates, over all rays.
struct MomentSummary
{
  std::size_t rays = 0;  ///< rays that have the moment; without them all else is 0
  std::size_t gates = 0; ///< of the longest ray
  int firstGate = 0;     ///< m, of the first ray that has the moment
  int gateSpacing = 0;   ///< m, likewise
  std::size_t valid = 0; ///< gates that hold a value
  std::size_t belowThreshold = 0;
  std::size_t rangeFolded = 0;
  std::size_t status = 0; ///< CFP: gates that hold a code in place of a value
  double minimum = 0.0;   ///< of the values, in the moment's unit; 0 without any
  double maximum = 0.0;
  double mean = 0.0;
};

/// Counts a moment's words. The mean is exact to the rounding of its last step.
MomentSummary Summarize(const Sweep& sweep, MomentName moment);

} // namespace nexrad

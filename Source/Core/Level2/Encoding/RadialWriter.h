// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "nexrad/Level2/Encoding/MessageWriter.h"
#include "nexrad/Model/RadarVolume.h"

namespace nexrad
{

/// One ray as message 1 (`sequence` counts the messages, `index` the rays of the sweep, from 0).
/// Throws Error for what message 1 cannot hold.
MessageBytes WriteMessage1(
  const RadarVolume& volume, const Ray& ray, unsigned index, unsigned sequence);

/// One ray as message 31. Throws Error for what it cannot hold, and without a position.
MessageBytes WriteMessage31(
  const RadarVolume& volume, const Sweep& sweep, unsigned index, unsigned sequence);

} // namespace nexrad

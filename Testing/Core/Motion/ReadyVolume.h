// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "nexrad/Beams/BeamVolume.h"

#include <memory>

namespace nexrad::testing
{

inline const Time zero = *ParseIso8601("2006-03-12T18:00:00Z");

/// As MotionTracker takes volumes.
inline std::shared_ptr<const BeamVolume> Ready(const PolarVolume& volume)
{
  return std::make_shared<const BeamVolume>(PrepareBeamVolume(volume));
}

} // namespace nexrad::testing

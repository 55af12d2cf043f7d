// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "nexrad/Model/RadarVolume.h"

namespace nexrad
{

/// Whether the last volume of a file has no end, so that the file behind it may tell why.
bool LacksEnd(const RadarVolume& volume);

/// Where the radar broke that volume off (IsBrokenOff) and began `next`, of another file: takes the
/// missing end out of the damage, and the cuts that follow out of those that are missing; a note
/// says what became of them.
void EndWithNext(RadarVolume& volume, const RadarVolume& next);

} // namespace nexrad

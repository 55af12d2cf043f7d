// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "nexrad/Beams/BeamSweep.h"
#include "nexrad/Polar/GateCode.h"

namespace nexrad
{

/// Reduces a sweep for voxels that are `side` m wide. Along the range, gates are put together where
/// the side is more than twice their spacing; across it, rays where it is more than twice theirs
/// and more than the gates' spacing. Without either, and for a moment that takes the nearest gate,
/// the means are empty.
SweepMeans MakeSweepMeans(const BeamSweep& sweep, const ValueRule& rule, double side);

} // namespace nexrad

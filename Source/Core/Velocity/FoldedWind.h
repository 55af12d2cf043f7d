// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "nexrad/System/RangeLoop.h"
#include "nexrad/Velocity/VelocityVolume.h"
#include "nexrad/Velocity/WindProfile.h"

#include <vector>

namespace nexrad
{

/// The wind profile of a volume from its velocities as they are, folded (Formulas V3): in layers of
/// 400 m, the wind whose radial component, folded alike, agrees best with the velocities of all
/// sweeps within 120 km, as the sum of cos(π·(v − wind)/v_N) tells. Folds do not change it, so
/// that no fold has to be known before. Layers seen from few directions can have several such
/// winds; of those the profile takes what agrees with the layers above and below. A layer without
/// a clear wind has no level.
WindProfile FindFoldedWind(const std::vector<const SweepRing*>& sweeps, const RangeLoop& loop = {});

} // namespace nexrad

// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "nexrad/Simulation/StormLife.h"

#include <cstdint>
#include <vector>

namespace nexrad
{

/// All storms of a day. Their times and places are spread evenly, so that the activity is much the
/// same whatever the seed.
std::vector<StormLife> MakeStormDay(std::uint32_t seed);

} // namespace nexrad

// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "nexrad/Quality/SweepJudgement.h"

namespace nexrad
{

/// Finds the ground of a sweep: connected regions of gates with signs of ground that have enough
/// sure ones, unless the echo about a region moves slowly: weather turns past zero velocity there.
/// Regions that are gone in the tilt above, and low, are ground anyhow. Sets the reasons of their
/// gates. `polarimetric`: whether ρ_hv and Z_DR are known of the sweep.
void FindGround(SweepJudgement& sweep, bool polarimetric);

} // namespace nexrad

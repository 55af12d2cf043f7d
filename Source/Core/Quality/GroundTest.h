// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "nexrad/Quality/SweepJudgement.h"

namespace nexrad
{

/// Judges the gates of a sweep of one polarisation that FindGround asks about, in place of all.
/// Nothing is surely ground that does not stand still (FindInterest), and likely ground counts only
/// in a region that is partly sure. So the gates that stand still are judged first, and then the
/// rays about sure ground, more and more of them, until the region of each sure gate and what lies
/// beside it are judged.
void SearchGround(SweepJudgement& sweep, const SweepSources& sources);

/// Finds the ground of a sweep: connected regions of gates with signs of ground that have enough
/// sure ones, unless the echo about a region moves slowly: weather turns past zero velocity there.
/// Regions that are gone in the tilt above, and low, are ground anyhow. Sets the reasons of their
/// gates. `polarimetric`: whether ρ_hv and Z_DR are known of the sweep.
void FindGround(SweepJudgement& sweep, bool polarimetric);

} // namespace nexrad

// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "nexrad/Quality/SweepJudgement.h"

namespace nexrad
{

/// Judges the gates of a sweep of one polarisation that FindGround asks about, in place of all.
/// Nothing is surely ground that does not stand still, and likely ground counts only in a region
/// that is partly sure. So the gates that stand still are judged first, and then the rays about
/// sure ground, more and more of them, until the region of each sure gate and what lies beside it
/// are judged.
void SearchGround(SweepJudgement& sweep, const SweepSources& sources);

/// Finds the ground of a sweep: connected regions of gates with signs of ground that have enough
/// sure ones, unless the echo about a region moves slowly: weather turns past zero velocity there.
/// Regions that are gone in the tilt above, and low, are ground anyhow. Sets the reasons of their
/// gates.
void FindGround(SweepJudgement& sweep);

/// Finds the anomalous propagation of a low sweep that moves, such as that over the sea (Formulas
/// Q1): connected regions of echo of which the tilt above has nothing anywhere, though it is strong
/// enough to be seen there if it were weather, and rough or strong as no shallow layer is. Regions
/// along whose edge the tilt above has echo are edges of weather, and stay. Of two polarisations,
/// only regions that these do not call weather count. Sets the reasons of their gates.
void FindPropagation(SweepJudgement& sweep);

} // namespace nexrad

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

} // namespace nexrad

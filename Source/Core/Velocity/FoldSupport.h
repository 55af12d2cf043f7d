// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "nexrad/Velocity/FoldPlacement.h"

#include <vector>

namespace nexrad
{

/// Makes unknown the folds for which nothing vouches (Formulas V4). A gate whose fold is 0 keeps
/// the velocity of the file. A gate with another fold keeps it when
/// - it is of a broad patch of like velocities, over more than 5° of azimuth, that holds gates of
///   fold 0 as well, or of a narrow patch along whose edge there are broad ones; or
/// - the patch is near to the wind profile at its place, for gates up to FastestWind; or
/// - the patch is near to velocities of other sweeps at its place, for which one of these vouches.
///
/// Radio interference, the sun and noise give patches of a few rays; echo of an earlier pulse gives
/// patches far from all others.
void RemoveUnsupportedFolds(
  std::vector<SweepFolds>& sweeps, const WindProfile& wind, const RangeLoop& loop);

/// The speed, m/s, from which on the wind profile alone does not vouch for a velocity, at a height
/// in m above the antenna: 60 up to 5 km, rising to 100 at 10 km and above. Of more than 12,000
/// sondes dropped into tropical cyclones, one in 200 met 90 m/s [Stern]; elsewhere such winds are
/// those of tornadoes and jet streams.
double FastestWind(double height);

} // namespace nexrad

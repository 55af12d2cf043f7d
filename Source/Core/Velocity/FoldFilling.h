// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "nexrad/Velocity/FoldPlacement.h"

namespace nexrad
{

/// Finds the folds of the gates of a sweep that are of no region, or of one that was not placed:
/// those to which the gates about them are near, in several turns. A gate that agrees with none of
/// its neighbours stays without a fold.
void FillFolds(SweepFolds& sweep);

/// The folds of all gates of a sweep: those that it has, and those of gates without any neighbour
/// of known fold that are within half a Nyquist velocity of what the wind profile and the sweeps
/// below and above lead to expect. The others stay without a fold (Formulas V4).
std::vector<Fold> PlaceLoneGates(const SweepFolds& sweep, const ExpectedVelocities& expected);

} // namespace nexrad

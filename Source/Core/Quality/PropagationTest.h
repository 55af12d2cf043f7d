// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "nexrad/Quality/SweepJudgement.h"

namespace nexrad
{

/// Finds the anomalous propagation of a low sweep that moves, such as that over the sea (Formulas
/// Q1): connected regions of echo of which the tilt above has nothing anywhere, though it is strong
/// enough to be seen there if it were weather, and rough or strong as no shallow layer is. Regions
/// along whose edge the tilt above has echo are edges of weather, and stay. Sets the reasons of
/// their gates. `polarimetric`: whether ρ_hv and Z_DR are known of the sweep; then only regions
/// that these do not call weather count.
void FindPropagation(SweepJudgement& sweep, bool polarimetric);

} // namespace nexrad

// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "nexrad/Quality/EchoClass.h"
#include "nexrad/Quality/EchoGrid.h"

#include <vector>

namespace nexrad
{

/// Finds spikes and rays at one value in a sweep (Formulas Q3), and sets the reasons of their
/// gates: ConstantPower and ConstantValue. `reasons`: rays × gates, in the order of the rays of the
/// sweep.
void FindSpikes(const EchoGrid& grid, std::vector<EchoReason>& reasons);

} // namespace nexrad

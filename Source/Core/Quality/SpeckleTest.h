// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "nexrad/Quality/SweepJudgement.h"

namespace nexrad
{

/// Finds the speckle of a sweep (Formulas Q3): weather and biological echo of which fewer than
/// three gates are connected. Sets the reasons of these gates to FewGates.
void FindSpeckle(SweepJudgement& sweep);

} // namespace nexrad

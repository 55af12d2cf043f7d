// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Sheets/Sheet.h"

namespace nexrad::scene
{

/// The sweeps of the first radar's volume nearest to the time, as layered cones, from the side and
/// from above (the thesis's figure 3.8).
Sheet DrawSweepsSheet(const SheetSource& source);

} // namespace nexrad::scene

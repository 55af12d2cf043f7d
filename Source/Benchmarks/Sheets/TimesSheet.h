// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Sheets/Sheet.h"

#include <cstddef>
#include <vector>

namespace nexrad::scene
{

/// The volumes nearest to 00:10, 06:10, 18:10 and 23:10 UTC of the day, seen 20° from the vertical
/// (the thesis's figure 4.1). Of a series that does not reach over these times, four steps from the
/// first to the last.
Sheet DrawTimesSheet(const SheetSource& source);

/// The steps that DrawTimesSheet shows: indices of `times`, ascending.
std::vector<std::size_t> ChooseTimesOfDay(const std::vector<Time>& times, Duration step);

} // namespace nexrad::scene

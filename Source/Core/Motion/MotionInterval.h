// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "nexrad/Model/Time.h"

namespace nexrad
{

/// Longest time between two volumes of one radar from which the motion of the echo is estimated
/// (Formulas A3a).
constexpr Duration LongestMotionInterval = std::chrono::minutes(20);

} // namespace nexrad

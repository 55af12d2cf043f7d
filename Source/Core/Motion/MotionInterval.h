// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "nexrad/Model/Time.h"

namespace nexrad
{

/// Longest time between two volumes of one radar from which the motion of the echo is estimated
/// (Formulas A3a).
constexpr Duration LongestMotionInterval = std::chrono::minutes(20);

/// Shortest time between two volumes of one radar that gives the motion of the echo in full
/// (Formulas A3a): from a shorter one, a small error of the displacement is a large one of the
/// speed.
constexpr Duration ShortestMotionInterval = std::chrono::minutes(3);

} // namespace nexrad

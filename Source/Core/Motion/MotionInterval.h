// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "nexrad/Model/Time.h"

namespace nexrad
{

/// Two volumes of one radar farther apart tell nothing about the motion of echo between them
/// (Formulas A3a).
constexpr Duration LongestMotionInterval = std::chrono::minutes(20);

} // namespace nexrad

// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "nexrad/Model/Time.h"

namespace nexrad
{

/// The first and the last millisecond of the years 1 to 9999, which ISO 8601 writes with four
/// digits. Readers refuse other times: sums with them would overflow.
constexpr Time EarliestTime{Duration(-62'135'596'800'000)};
constexpr Time LatestTime{Duration(253'402'300'799'999)};

} // namespace nexrad

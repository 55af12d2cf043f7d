// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "nexrad/System/Progress.h"

namespace nexrad::application
{

using nexrad::ShareOf;

/// Share of the whole that finding out what radar files hold takes, before they are merged.
constexpr double scanShare = 0.3;

} // namespace nexrad::application

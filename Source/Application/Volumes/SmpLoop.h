// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "nexrad/System/RangeLoop.h"

namespace nexrad::application
{

/// A loop that vtkSMPTools runs.
RangeLoop SmpLoop();

/// Threads that vtkSMPTools uses, at least 1.
unsigned ThreadCount();

} // namespace nexrad::application

// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "BenchOptions.h"

namespace nexrad::application
{

/// Sets two reports side by side. Returns an ExitStatus.
int RunBenchComparison(const BenchOptions& options);

} // namespace nexrad::application

// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "BenchOptions.h"

namespace nexrad::application
{

/// Measures and prints the tables. Returns an ExitStatus.
int RunBenchTables(const BenchOptions& options);

} // namespace nexrad::application

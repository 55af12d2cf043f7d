// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "BenchOptions.h"

namespace nexrad::application
{

/// Draws sheets of pictures in place of the tables, and prints their numbers. Returns an
/// ExitStatus.
int RunBenchSheets(const BenchOptions& options);

} // namespace nexrad::application

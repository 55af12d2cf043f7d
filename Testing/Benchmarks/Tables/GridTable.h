// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Tables/BenchTable.h"
#include "Tables/Benchmark.h"

namespace nexrad::application
{

/// The time of one merged volume by dimensions and number of sites (1, 2, 4, … and all), with the
/// rays of both bracketing volumes of each site in memory. The first volume of a run, which also
/// places the sites on the grid, stands apart. Throws Error when
/// they cannot be merged.
BenchTable MakeGridTable(const BenchRequest& request);

} // namespace nexrad::application

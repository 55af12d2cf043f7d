// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Report/BenchReport.h"

#include <string>
#include <vector>

namespace nexrad::application
{

/// Two runs of the benchmark side by side.
struct Comparison
{
  std::vector<BenchTable> tables;    ///< one for each quantity: names, A, B and B / A
  std::vector<std::string> problems; ///< what only one of them has, or measured otherwise
};

/// Sets what both measured side by side: each measured column of each table that both have, row by
/// row as the names of the rows say. No table when they have nothing in common.
Comparison CompareReports(const BenchReport& a, const BenchReport& b);

} // namespace nexrad::application

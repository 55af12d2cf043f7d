// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Report/BenchTable.h"
#include "Report/Machine.h"

#include <cstddef>
#include <filesystem>
#include <iosfwd>
#include <string>
#include <vector>

namespace nexrad::application
{

/// What one run of the benchmark found.
struct BenchReport
{
  Machine machine;
  int runs = 1;           ///< of each measurement
  bool synthetic = false; ///< some of the files are simulated
  std::size_t files = 0;  ///< that were measured
  std::vector<BenchTable> tables;
};

/// Prints machine, files and tables for a person.
void PrintReport(const BenchReport& report, std::ostream& out);

/// The same as JSON, which ReadReport takes back.
nlohmann::ordered_json MakeReportJson(const BenchReport& report);

/// Reads what `nexrad3d bench --json` printed. Throws Error, naming the file and what is wrong, for
/// a file that cannot be read or is something else.
BenchReport ReadReport(const std::filesystem::path& path);

} // namespace nexrad::application

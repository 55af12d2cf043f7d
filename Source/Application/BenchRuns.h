// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Bench/BenchRequest.h"
#include "Experiments/SheetRequest.h"

#include <nlohmann/json_fwd.hpp>

#include <filesystem>
#include <string>
#include <vector>

namespace nexrad::application
{

/// What the command line of bench asks for.
struct BenchOptions
{
  std::vector<std::filesystem::path> inputs; ///< empty: a series is simulated
  BenchRequest request;
  double hours = 0.5;                         ///< of the simulated series
  std::vector<std::string> only;              ///< names of tables, or of sheets; empty: all
  scene::SheetRequest sheets;                 ///< of what the command line says of sheets alone
  std::vector<std::filesystem::path> compare; ///< two reports
  bool json = false;
  bool quiet = false;
};

/// What can be measured; a name may stand for several tables.
constexpr const char* tableNames[] = {"decode", "grid", "series", "drawing"};

/// Measures and prints the tables.
int RunBenchTables(const BenchOptions& options);

/// Draws sheets of pictures in place of the tables, and prints their numbers.
int RunBenchSheets(const BenchOptions& options);

/// Sets two reports side by side.
int RunBenchComparison(const BenchOptions& options);

/// What they share: JSON on standard output; a line for each problem on standard error, and the
/// exit status that follows.
void PrintJson(const nlohmann::ordered_json& json);
int PrintProblems(const std::vector<std::string>& problems);

} // namespace nexrad::application

// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Sheets/SheetRequest.h"
#include "Tables/BenchRequest.h"

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

} // namespace nexrad::application

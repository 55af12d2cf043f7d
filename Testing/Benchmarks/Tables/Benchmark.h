// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Tables/BenchReport.h"
#include "nexrad/Merging/MergeOptions.h"
#include "nexrad/Series/Catalogue.h"

#include <array>
#include <filesystem>
#include <string>
#include <vector>

namespace nexrad::application
{

/// What the tables of a benchmark are made of.
struct BenchRequest
{
  std::vector<std::filesystem::path> files; ///< radar files
  SeriesScan scan;                          ///< what can be merged of them
  bool synthetic = false;                   ///< some of the files are simulated
  std::vector<std::array<int, 3>> dimensions;
  MergeOptions options; ///< of merging; the dimensions in it are not looked at
  int runs = 3;
  std::filesystem::path folder; ///< for what is written and removed again
};

/// "thesis", "beam".
inline std::string NameOf(MergeMethod method)
{
  return method == MergeMethod::Thesis ? "thesis" : "beam";
}

/// "256x256x128".
inline std::string FormatDimensions(const std::array<int, 3>& dimensions)
{
  return std::to_string(dimensions[0]) + 'x' + std::to_string(dimensions[1]) + 'x' +
         std::to_string(dimensions[2]);
}

/// The time steps of the files, two at least. Throws Error when there are fewer.
std::vector<Time> StepsOf(const BenchRequest& request);

/// A part of a benchmark, as `--only` names it: it adds its tables to the report. Throws Error when
/// it cannot be measured.
struct BenchPart
{
  const char* name;
  void (*measure)(const BenchRequest& request, BenchReport& report);
};

/// The main function of a program that measures: reads its options, measures the parts that they
/// name, and prints the tables. Exit status: 0 done; 1 nothing was measured; 2 wrong usage; 3 some
/// files or parts were left out, and standard error names them.
int RunBenchmark(
  int argc, const char* const* argv, const std::string& does, const std::vector<BenchPart>& parts);

} // namespace nexrad::application

// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "nexrad/Merging/MergeOptions.h"

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
  bool synthetic = false;                   ///< some of the files are simulated
  std::vector<std::array<int, 3>> dimensions;
  MergeOptions options; ///< of merging; the dimensions in it are not looked at
  int runs = 3;
};

/// "256x256x128".
inline std::string FormatDimensions(const std::array<int, 3>& dimensions)
{
  return std::to_string(dimensions[0]) + 'x' + std::to_string(dimensions[1]) + 'x' +
         std::to_string(dimensions[2]);
}

} // namespace nexrad::application

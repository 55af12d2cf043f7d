// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Report/BenchTable.h"
#include "Scene/Frame/CameraView.h"
#include "nexrad/Merging/MergeOptions.h"
#include "nexrad/System/Progress.h"

#include <array>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace nexrad::scene
{

/// The sheets of pictures there are: the experiments of the thesis's section 4.2, and its figures
/// 4.1 and 3.8.
constexpr const char* sheetNames[] = {"resolution", "slices", "times", "sweeps"};

/// Which sheets to draw of which radar files.
struct SheetRequest
{
  std::vector<std::filesystem::path> files;
  MergeOptions grid;                          ///< of merging; its dimensions are not looked at
  std::vector<std::array<int, 3>> dimensions; ///< of the sheet of resolutions; not empty. The
                                              ///< middle one is that of the other sheets
  std::optional<Time> time;             ///< of all sheets but that of times; empty: in the middle
  CameraView camera;                    ///< of the sheets of resolutions and slices
  std::array<int, 2> size = {796, 532}; ///< of each picture, pixels; the thesis's
  std::filesystem::path folder;         ///< for the sheets; made when it does not exist
  std::vector<std::string> only;        ///< names among sheetNames; empty: all
  Progress progress;
};

/// What was drawn. A sheet that could not be drawn is among the problems.
struct SheetReport
{
  std::vector<std::filesystem::path> outputs;  ///< NAME.png and NAME.json of each sheet
  std::vector<application::BenchTable> tables; ///< the numbers of each sheet
  std::vector<std::string> problems;           ///< a line each
  std::string error;                           ///< why nothing was drawn; "" when something was
};

} // namespace nexrad::scene

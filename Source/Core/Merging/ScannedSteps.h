// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "nexrad/Merging/MergeOptions.h"
#include "nexrad/Merging/PolarCache.h"
#include "nexrad/Merging/TimeMerge.h"

#include <filesystem>
#include <optional>
#include <vector>

namespace nexrad
{

/// Merges radar files at time steps in any order. All files are decoded first, to learn what they
/// hold; their rays are kept packed, up to a limit of memory.
class ScannedSteps
{
public:
  /// Scans, together with the processes of `share`; when one of them fails, all throw Error.
  ScannedSteps(const std::vector<std::filesystem::path>& inputs, const MergeOptions& options,
    const RangeLoop& loop, const ScanShare& share, const Progress& progress);

  /// Finds the grid and the time steps. Throws Error when no input holds a volume, or for options
  /// that cannot be met.
  void Plan();

  /// After Plan.
  const std::vector<Time>& Times() const { return times; }
  const std::vector<InputProblem>& Problems() const { return scan.problems; }

  /// The volume of a step. Empty when `progress` asked to stop. Throws Error when it cannot be
  /// made.
  std::optional<GriddedVolume> Merge(Time time, const Progress& progress);

private:
  const MergeOptions options;
  MergeRequest request;
  PolarCache cache;
  SeriesScan scan;
  MergeRun run;
  std::vector<Time> times;
};

} // namespace nexrad

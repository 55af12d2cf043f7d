// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "nexrad/Merging/TimeMerge.h"

#include <filesystem>
#include <map>
#include <memory>
#include <vector>

namespace nexrad::testing
{

/// Merged volumes made in the plainest way: all files are decoded first, and every volume is handed
/// to each merge, which chooses among them. What the other ways are held against.
class DirectMerge
{
public:
  DirectMerge(const std::vector<std::filesystem::path>& inputs, const MergeOptions& options);

  const SeriesScan& Scan() const { return scan; }
  std::vector<Time> Times() const { return TimeStepsOf(options, scan); }
  GriddedVolume At(Time time) const;

private:
  const MergeOptions options;
  std::vector<std::shared_ptr<const PolarVolume>> volumes;
  SeriesScan scan;
};

/// Merges at several times, or of several blocks, by requests that differ in nothing else: each
/// volume is made ready once.
struct DirectRun
{
  MergeRun merge;
  std::map<const PolarVolume*, ReadyVolume> ready;
};

/// Merges volumes of any number of sites, in any order: of each site those about the time.
std::optional<GriddedVolume> MergeDirectly(const std::vector<const PolarVolume*>& volumes,
  const MergeRequest& request, const Progress& progress = {}, DirectRun* run = nullptr);

} // namespace nexrad::testing

// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "nexrad/Merging/MergeOptions.h"
#include "nexrad/Merging/TimeMerge.h"
#include "nexrad/Merging/VolumeStream.h"
#include "nexrad/Series/InputFiles.h"
#include "nexrad/Series/SeriesOutline.h"

#include <cstddef>
#include <memory>
#include <mutex>
#include <optional>
#include <vector>

namespace nexrad
{

/// A grid that becomes known while files are being decoded.
class PlannedGrid
{
public:
  void Set(const GridSpecification& grid);
  /// Empty as long as it is not known.
  std::optional<GridSpecification> Get() const;

private:
  mutable std::mutex mutex;
  std::optional<GridSpecification> grid;
};

/// Merges radar files at time steps that ascend, while the files are decoded a little ahead of
/// them. It trusts the files' headers where to look for volumes; IsAsIn tells afterwards whether
/// they erred.
class StreamedSteps
{
public:
  /// `threads` decode, `loop` merges. Throws Error for options that cannot be met.
  StreamedSteps(const InputFiles& inputs, std::vector<SiteOutline> outline,
    const MergeOptions& options, const RangeLoop& loop, unsigned threads);

  /// Finds the grid and the time steps, from one file of each site or two. False when the rays of
  /// these files say otherwise than the headers; then all files must be scanned. Throws Error for
  /// options that cannot be met.
  bool Plan();

  /// After Plan.
  const std::vector<Time>& Times() const { return times; }

  /// The last step that will be merged; before the first is.
  void EndAt(Time time) { stream.EndAt(time); }

  /// The volume of a step, not before an earlier one. The arrays of `memory` are used again. Empty
  /// when `progress` asked to stop. Throws Error when it cannot be made.
  std::optional<GriddedVolume> Merge(Time time, const Progress& progress, GriddedVolume memory);

  /// What was decoded so far, in the order of the inputs; of other files an empty entry.
  std::vector<ScannedFile> Scanned() const { return stream.Scanned(); }

  /// True when grid, time steps and the volumes chosen are those that a scan of all files leads to.
  bool IsAsIn(const SeriesScan& scan) const;

private:
  std::size_t CountVolumes();

  const MergeOptions options;
  const std::vector<SiteOutline> outline;
  MergeRequest request;
  const std::shared_ptr<PlannedGrid> plannedGrid = std::make_shared<PlannedGrid>();
  VolumeStream stream;
  MergeRun run;
  std::vector<Time> times;
};

} // namespace nexrad

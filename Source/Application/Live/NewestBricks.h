// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Volumes/VolumeFiles.h"
#include "nexrad/Codec/NxvPatch.h"
#include "nexrad/Live/LiveSeries.h"

#include <filesystem>
#include <optional>

namespace nexrad::application
{

/// The newest merged volume of a series, in bricks. It is ahead of the newest ray, so that a sweep
/// that arrives changes the columns of voxels that it crosses, and no others.
class NewestBricks
{
public:
  /// `series` must outlive the object. `written` says how the volumes are stored.
  NewestBricks(LiveSeries& series, std::filesystem::path path, const VolumeFiles& written);

  /// The time of the volume while a ray is the newest one: that of the volume before as long as the
  /// ray is not newer. Else the next full minute after the time that four whole merges take, so
  /// that these take a fourth of the time; that is a minute at least and `most`, or a minute, at
  /// most.
  Time TimeFor(Time ray, Duration most) const;

  /// Brings the file to what the series has for a time. As long as the time and the domain stay,
  /// motion stays what it was for the first volume at that time, and only columns that differ are
  /// merged. False when `progress` asked to stop; the file is then as before.
  bool Make(Time time, const Progress& progress);

private:
  void Renew(PlannedMerge now);

  LiveSeries& series;
  const std::filesystem::path path;
  const VolumeFiles written;
  std::optional<PlannedMerge> merge; ///< of what the file has
  std::optional<NxvPatcher> bricks;  ///< of the file
  Duration wholeTook{};              ///< to merge and write it as a whole
};

} // namespace nexrad::application

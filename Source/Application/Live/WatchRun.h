// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Live/LiveIntake.h"
#include "Volumes/VolumeFiles.h"
#include "nexrad/Merging/MergeOptions.h"

#include <chrono>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace nexrad::application
{

/// Folders that are followed, and what is kept current of them.
struct WatchJob
{
  std::vector<std::filesystem::path> folders; ///< into which volumes or chunks arrive
  std::filesystem::path output;               ///< made when it does not exist
  VolumeFiles written;                        ///< how the volumes are stored; VolumeFormat::Nxv
  MergeOptions options;
  std::string recipe; ///< all that decides what the volumes contain, beside the files, as text
  IntakeRules intake;
  Duration stale = std::chrono::minutes(10); ///< a radar whose newest ray is older is STALE
  Duration late = std::chrono::minutes(30);  ///< what comes later does not change the series
  std::optional<Duration> keep;              ///< how long the volumes of the series stay
  std::optional<Duration> stopAfter;         ///< end when nothing came for so long
  std::chrono::milliseconds poll = std::chrono::milliseconds(250); ///< longest rest between looks
  std::vector<std::string> drawing; ///< words for `render`, which draws the newest volume; empty:
                                    ///< no picture
  std::optional<ReplayRequest> replay;
};

/// What a run made.
struct WatchReport
{
  std::size_t newest = 0;   ///< newest volumes, one after the other
  std::size_t steps = 0;    ///< volumes of the series that were written, also once more
  std::size_t problems = 0; ///< lines on files that were damaged or left out
};

/// Follows the folders until a signal asks to stop (WatchStopSignals), or nothing came for the time
/// of the job. Keeps in the output folder the newest merged volume, its picture, the volumes of the
/// time steps with their index, and status.json. Only the radar of which something came is made
/// ready anew. Memory does not grow with time: what no open time step needs is dropped. A run that
/// was ended in any way is continued by the next one with the same recipe. `tell` takes lines for
/// the user, `complain` lines on files. Throws Error when the output cannot be written. However the
/// run ends, but for a kill, status.json says that it stopped, and why.
WatchReport WatchFolders(const WatchJob& job, const std::function<void(const std::string&)>& tell,
  const std::function<void(const std::string&)>& complain);

} // namespace nexrad::application

// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Live/LiveIntake.h"
#include "Volumes/VolumeFiles.h"
#include "nexrad/Grid/GriddedVolume.h"
#include "nexrad/Model/Site.h"
#include "nexrad/Model/Time.h"
#include "nexrad/System/AtomicFile.h"

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace nexrad::application
{

/// How long after the last byte of a sweep the volume with it was there, real time.
struct LiveDelays
{
  double last = 0.0;    ///< s
  double largest = 0.0; ///< s
  double sum = 0.0;     ///< s
  std::size_t count = 0;

  void Add(double seconds);
};

/// One radar of a series that grows.
struct RadarStatus
{
  std::optional<Time> newest; ///< last ray that is used
  bool live = false;          ///< that is not older than the longest age
  ArrivingRadar arriving;
};

/// All that a series that grows says of itself: status.json (Documentation/Formats/status.md).
struct LiveStatus
{
  std::string state = "running"; ///< running, or stopped
  std::string reason;            ///< why it stopped
  Time written{};                ///< by the clock
  Duration staleAge{};           ///< a radar whose newest ray is older is STALE
  std::optional<Time> newest;    ///< time of the newest volume
  std::string newestFile;
  std::string pictureFile; ///< empty without a picture
  std::optional<Time> pictureTime;
  std::vector<Time> steps; ///< of the series
  std::map<std::string, RadarStatus> radars;
  std::size_t problems = 0;
  std::size_t heldBytes = 0; ///< that the held volumes take
  LiveDelays delays;
  std::vector<std::string> notes;
};

/// One line for a person: "18:05:21Z KEAX LIVE 12 s, KLSX STALE 15 min". Of more than twelve radars
/// it names those that are STALE, up to twelve of them, and counts the others.
std::string StatusLine(const LiveStatus& status);

/// What a run that goes on has to know of the one before.
struct LiveState
{
  std::string steps; ///< StepBook::Pack; empty: nothing was made yet
  std::map<std::string, std::pair<Site, double>> radars; ///< LiveSeries::Sites
  bool keepsGrid = false;                                ///< the domain changes no more
};

/// The folder of a series that grows: the volumes of its time steps, their index, the newest volume
/// and the status. Each file is replaced as a whole. While this object lives, no other run can
/// write into the folder. The hidden folder ".watch" in it has what the next run goes on with.
class LiveFolder
{
public:
  /// Makes the folder when it does not exist. Throws Error when it cannot be written to, and when
  /// another run writes into it.
  LiveFolder(std::filesystem::path folder, std::string recipe);
  ~LiveFolder();
  LiveFolder(const LiveFolder&) = delete;
  LiveFolder& operator=(const LiveFolder&) = delete;

  std::filesystem::path NewestVolume() const;

  /// What the run before left; as new without one. Keeps room for the last status. Throws Error
  /// when that run had another recipe, or what it left cannot be read.
  LiveState GoOn() const;

  /// The place of the volume of a time step.
  std::filesystem::path StepVolume(Time time) const;
  /// Removes the volume of a time step, if it is there.
  void RemoveStep(Time time) const;
  void WriteIndex(const std::vector<Time>& steps) const;
  void WriteState(const LiveState& state) const;
  /// The status of a run that fails, perhaps because the disk is full: takes room that was kept for
  /// it. Does nothing where it cannot be written all the same.
  void WriteLastStatus(const LiveStatus& status) const noexcept;
  void WriteStatus(const LiveStatus& status) const;

private:
  LiveState ReadState() const;

  const std::filesystem::path folder;
  const std::string recipe;
  FileDescriptor lock;     ///< among runs of watch
  FileDescriptor gridLock; ///< among runs of grid, and this one
};

} // namespace nexrad::application

// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Volumes/StepWriter.h"
#include "nexrad/Grid/GriddedVolume.h"
#include "nexrad/Model/Site.h"
#include "nexrad/System/AtomicFile.h"

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

namespace nexrad::application
{

/// What a run that goes on has to know of the one before.
struct LiveState
{
  std::string steps;                           ///< StepBook::Pack; empty: nothing was made yet
  std::vector<std::pair<Site, double>> radars; ///< those that made the domain, with their ranges, m
  bool keepsGrid = false;                      ///< the domain changes no more
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

  const std::filesystem::path& Path() const { return folder; }
  std::filesystem::path NewestVolume() const;
  std::filesystem::path Index() const;

  /// Reads what the run before left, and keeps room for the last status. Throws Error when that run
  /// had another recipe, or what it left cannot be read.
  void GoOn();
  /// What the run before left; as new without one.
  const LiveState& Before() const { return before; }

  void WriteNewest(const GriddedVolume& volume) const;
  /// The volume of a time step, under its name.
  void WriteStep(const GriddedVolume& volume) const;
  /// Removes the volume of a time step, if it is there.
  void RemoveStep(Time time) const;
  void WriteIndex(const std::vector<Time>& steps) const;
  void WriteState(const LiveState& state) const;
  /// The status of a run that fails, perhaps because the disk is full: takes room that was kept for
  /// it. Does nothing where it cannot be written all the same.
  void WriteLastStatus(const std::string& text) const noexcept;
  void WriteStatus(const std::string& text) const;

private:
  void Lock();
  void Unlock();
  void ReadState();

  const std::filesystem::path folder;
  const std::string recipe;
  FileDescriptor lock;     ///< among runs of watch
  FileDescriptor gridLock; ///< among runs of grid, and this one
  LiveState before;
};

} // namespace nexrad::application

// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "nexrad/System/AtomicFile.h"
#include "nexrad/System/Processes.h"

#include <cstdint>
#include <filesystem>
#include <functional>
#include <set>
#include <string>
#include <vector>

namespace nexrad::application
{

/// Names of the files in a folder; none where it cannot be read.
std::set<std::string> FilesIn(const std::filesystem::path& folder);

/// A run that writes files into a folder, from its first file to its end. It keeps a hidden folder
/// there, ".grid.part", with what it was asked for. A run that was interrupted leaves it behind;
/// the next one with the same recipe has the files that are there, and one with another recipe
/// begins anew.
///
/// A file appears complete under its name as soon as it is written, unless the folder had a file of
/// that name before the run: then it waits in the hidden folder until the run has succeeded, so
/// that a run which fails changes nothing that was there.
///
/// Several processes may take part in one run; each writes files of its own.
class UnfinishedRun
{
public:
  static constexpr const char* HiddenName = ".grid.part";
  static constexpr const char* LockName = "lock"; ///< in the hidden folder; a run has it locked

  /// `recipe`: all that decides what the files contain, as text; empty: what an interrupted run
  /// left is never taken. The folder is made when it does not exist. All processes call it. Throws
  /// Error, in all processes, when the folder cannot be made or written to, and when another run
  /// writes into it.
  UnfinishedRun(
    const std::filesystem::path& folder, const std::string& recipe, const Processes& processes);
  /// Without End: removes the hidden folder when no run can go on with it.
  ~UnfinishedRun();
  UnfinishedRun(const UnfinishedRun&) = delete;
  UnfinishedRun& operator=(const UnfinishedRun&) = delete;

  /// From now on all files wait in the hidden folder until the run has succeeded, so that others
  /// can be made of them (PlaceFor tells where they are).
  void HoldBack() { holdsBack = true; }

  /// True when this run, or the interrupted one that it continues, wrote the file; it counts as
  /// written by this process from then on.
  bool Has(const std::string& name);
  /// Size of a file that the run has, bytes. Throws Error when it cannot be read.
  std::uintmax_t SizeOf(const std::string& name) const;
  /// The path to write a file to. AtomicFile, or what uses it, must write it.
  std::filesystem::path PlaceFor(const std::string& name) const;
  /// The file was written at its place. Throws Error when it cannot be given its name.
  void Add(const std::string& name);

  /// Adds a record to those of all processes, for a run that continues this one. It is there
  /// however the run ends. Throws Error when it cannot be written.
  void Keep(const std::string& bytes) const;
  /// The records of this run and of the one that it continues, in their order. Where a disk was
  /// full they may lack some.
  std::vector<std::string> Kept() const;

  /// Removes a file of the run, if it has it.
  void Remove(const std::string& name);
  /// Removes what the interrupted run left to wait under other names than these.
  void KeepOnly(const std::set<std::string>& names);
  /// Removes the files of this process, so that the run begins anew.
  void Discard();
  /// All files are there: gives those that wait their names, calls `last` in the first process, and
  /// removes the hidden folder. All processes call it. Throws Error, in all processes, when a file
  /// cannot be renamed or `last` throws it.
  void End(const std::function<void()>& last);

private:
  void Open(const std::string& recipe);
  void Begin(const std::string& recipe);
  bool Continues(const std::string& recipe) const;
  void ReadJournal();
  void RemoveWaiting();
  void RemoveHidden();
  bool Waits(const std::string& name) const { return holdsBack || replaced.count(name) > 0; }
  std::filesystem::path PathOf(const std::string& name) const;

  const std::filesystem::path folder;
  const std::filesystem::path hidden;
  const Processes processes;
  const bool canGoOn;
  FileDescriptor lock; ///< of the first process
  bool holdsBack = false;
  std::set<std::string> replaced; ///< names that the folder had before the run
  std::set<std::string> written;  ///< by this process
};

} // namespace nexrad::application

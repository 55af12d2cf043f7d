// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

namespace nexrad::application
{

/// A part of a run that merges volumes in bricks. Each task is a process, and waits for no other:
/// whoever starts them sees to their order. First all scans, then all rows, then the join.
struct GridTask
{
  enum class Kind
  {
    Scan, ///< decodes a part of the radar files, and leaves behind what they hold
    Rows, ///< makes a part of the rows of each volume
    Join  ///< joins the rows to the volumes that one run alone would make, and ends the run
  };
  Kind kind = Kind::Join;
  std::size_t part = 0; ///< from 0 on; of Scan and Rows
  std::size_t parts = 1;
};

/// From "scan:1/4", "rows:4/4" or "join". Throws Error for any other text.
GridTask ParseGridTask(const std::string& text);

/// What the tasks of a run leave for each other: a hidden folder in the folder of the volumes,
/// named by the run's recipe (".grid.tasks-0a1b2c3d"), so that tasks of other options share
/// nothing.
class TaskFolder
{
public:
  /// `recipe`: all that decides what the volumes contain, as text. The folder is not made yet.
  TaskFolder(const std::filesystem::path& folder, const std::string& recipe);

  /// Leaves what the files of a part hold (SeriesMerger::KnownFiles), and returns the path. Throws
  /// Error when it cannot be written.
  std::filesystem::path PutKnown(const GridTask& task, const std::string& known) const;
  /// What all scans left. Throws Error when there is none, and when one is missing.
  std::vector<std::string> Known() const;

  /// Where a task writes its rows of a volume. Throws Error when the folder cannot be made.
  std::filesystem::path PlaceForRows(const std::string& volume, const GridTask& task) const;
  /// Says what the rows that a task wrote, or would have if it had any, are made of. Throws Error
  /// when it cannot be written.
  void PutMade(const std::string& volume, const GridTask& task, const std::string& made) const;
  /// The rows of a volume, from the first to the last part that has any. Throws Error when there
  /// are none, when one is missing, and when one is made of something else.
  std::vector<std::filesystem::path> RowsOf(
    const std::string& volume, const std::string& made) const;

  /// Removes all of it.
  void Remove() const;

private:
  void Make() const;
  std::vector<std::filesystem::path> Find(const std::string& name, const std::string& task) const;

  const std::filesystem::path hidden;
};

} // namespace nexrad::application

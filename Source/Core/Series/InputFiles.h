// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "nexrad/Model/Time.h"
#include "nexrad/System/Error.h"

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace nexrad
{

/// The inputs cannot be used: one of them does not exist, or none holds a volume that can be used.
class InputError : public Error
{
public:
  InputError(const std::string& what, bool missing)
    : Error(what)
    , isMissing(missing)
  {
  }

  const bool isMissing; ///< an input does not exist
};

/// What is wrong with one input: damage, or why it could not be used.
struct InputProblem
{
  std::string file;                    ///< path as found
  std::optional<std::uint64_t> offset; ///< byte offset in the stored file, when one is known
  std::string what;                    ///< one line
  bool leftOut = false;                ///< nothing of the file, or of one cycle of it, is used
  bool isMissingEnd = false;           ///< Damage::isMissingEnd

  /// "FILE: offset N: WHAT", or "FILE: WHAT" without an offset.
  std::string Line() const;
};

/// The lines of problems, in their order.
std::vector<std::string> ProblemLines(const std::vector<InputProblem>& problems);

/// The radar files that a user's list of files and folders stands for.
struct InputFiles
{
  std::vector<std::filesystem::path> paths; ///< Level II files, also members of tar archives, and
                                            ///< chunk folders as one path each
  std::vector<InputProblem> problems;       ///< files in the folders that are no Level II files
};

/// True for a folder that holds pieces of the real-time feed ("20210729-123848-001-S": a date, a
/// time, a number, and S, I or E). ReadLevel2 takes such a folder as one volume.
bool IsChunkFolder(const std::filesystem::path& path);

/// Replaces each folder by the files in it and in its folders, in the order of their names; a chunk
/// folder stays one path. A tar archive counts as a folder of its members. Files whose name begins
/// with a dot are passed over. A path that is given twice counts once. Throws InputError for a path
/// that does not exist and for a folder without a file.
InputFiles FindInputFiles(const std::vector<std::filesystem::path>& inputs);

/// A file by what its header says of it.
struct TimedFile
{
  std::size_t index = 0; ///< in the list of paths
  Time time{};           ///< in the header; near the first ray's, as a rule
};

/// The order of their times.
inline bool IsEarlier(const TimedFile& a, const TimedFile& b)
{
  return a.time < b.time;
}

/// The files of radars, by the names in the headers; the rays may know better. Those of each radar
/// by time, then as they were given; never empty.
using FilesByRadar = std::map<std::string, std::vector<TimedFile>>;

/// Which files belong to which radar and time, from their first bytes: enough to decode them in the
/// order in which they are needed, not to rely on. `siteName`, when not empty, replaces the names
/// in the files. Empty when a header lacks a time or a name, or cannot be had without decompressing
/// much.
std::optional<FilesByRadar> ListByHeaders(
  const std::vector<std::filesystem::path>& paths, const std::string& siteName = {});

} // namespace nexrad

// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace nexrad
{

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

} // namespace nexrad

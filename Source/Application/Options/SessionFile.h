// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Options/DrawingOptions.h"
#include "nexrad/Model/Time.h"

#include <filesystem>
#include <optional>
#include <string>

namespace nexrad::application
{

/// The end of the names of session files.
constexpr char SessionSuffix[] = ".nxsession";

/// Whether a path has the name of a session file.
bool IsSessionFile(const std::filesystem::path& path);

/// What a window shows: its inputs, the time, and how they are drawn.
struct Session
{
  scene::DrawingRequest drawing;                      ///< `size`: of the picture
  bool synthetic = false;                             ///< the synthetic hour, in place of inputs
  std::optional<Time> shown;                          ///< empty: the first time
  Duration interval = std::chrono::milliseconds(500); ///< from one step to the next in playing
  std::string colours; ///< a colour map of ParaView (JSON) that was edited; empty: none
};

/// Writes a session (Documentation/Formats/session.md), with absolute paths. The file appears whole
/// or not at all. Throws Error when it cannot be written.
void WriteSession(const std::filesystem::path& path, const Session& session);

/// Reads a session. Relative paths in it start at the folder of the file. Throws Error, of one line
/// with the file and the key, for a file that cannot be read, is no session, is of a later version,
/// or has a key or a value that this program does not know.
Session ReadSession(const std::filesystem::path& path);

} // namespace nexrad::application

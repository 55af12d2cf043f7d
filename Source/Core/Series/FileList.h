// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "nexrad/Model/Time.h"

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace nexrad
{

/// A file by what its header says of it.
struct TimedFile
{
  std::size_t index = 0; ///< in the list of paths
  Time time{};           ///< in the header; near the first ray's, as a rule
};

/// The files of one radar by what their headers say.
struct SiteFileList
{
  std::string name;             ///< of the radar; the rays may know better
  std::vector<TimedFile> files; ///< by time, then as they were given; never empty
};

/// Which files belong to which radar and time, from their first bytes: enough to decode them in the
/// order in which they are needed, not to rely on. `siteName`, when not empty, replaces the names
/// in the files. Empty when a header lacks a time or a name, or cannot be had without decompressing
/// much.
std::optional<std::vector<SiteFileList>> ListByHeaders(
  const std::vector<std::filesystem::path>& paths, const std::string& siteName = {});

} // namespace nexrad

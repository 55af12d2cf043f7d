// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace nexrad
{

/// One file of the real-time feed: "20210729-123848-001-S" starts the volume of that time, "-I"
/// goes on with it, "-E" ends it.
struct Chunk
{
  std::filesystem::path path;
  std::string volume; ///< "20210729-123848"
  int number = 0;     ///< from 1
  char kind = 'I';    ///< S, I or E
};

/// Empty when the file's name is not that of a chunk.
std::optional<Chunk> ParseChunkName(const std::filesystem::path& path);

/// The chunks of a folder, ordered by volume and number. Throws Error when it cannot be read.
std::vector<Chunk> ListChunks(const std::filesystem::path& folder);

} // namespace nexrad

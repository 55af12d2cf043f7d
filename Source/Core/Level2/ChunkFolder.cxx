// SPDX-License-Identifier: BSD-3-Clause
#include "Level2/ChunkFolder.h"

#include "Model/Error.h"

#include <algorithm>
#include <regex>
#include <system_error>
#include <tuple>

namespace fs = std::filesystem;

namespace nexrad
{

std::optional<Chunk> ParseChunkName(const fs::path& path)
{
  static const std::regex pattern("([0-9]{8}-[0-9]{6})-([0-9]{3})-([SIE])");
  const std::string name = path.filename().string();
  std::smatch parts;
  if (!std::regex_match(name, parts, pattern))
  {
    return std::nullopt;
  }
  return Chunk{path, parts[1], std::stoi(parts[2]), parts[3].str().front()};
}

std::vector<Chunk> ListChunks(const fs::path& folder)
{
  std::vector<Chunk> chunks;
  std::error_code error;
  for (fs::directory_iterator entry(folder, error), end; !error && entry != end;
       entry.increment(error))
  {
    if (auto chunk = ParseChunkName(entry->path()))
    {
      chunks.push_back(std::move(*chunk));
    }
  }
  if (error)
  {
    throw Error(folder.string() + ": cannot read the folder: " + error.message());
  }
  std::sort(chunks.begin(), chunks.end(),
    [](const Chunk& first, const Chunk& second)
    {
      return std::tie(first.volume, first.number, first.kind) <
             std::tie(second.volume, second.number, second.kind);
    });
  return chunks;
}

} // namespace nexrad

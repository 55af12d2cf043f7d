// SPDX-License-Identifier: BSD-3-Clause
#include "nexrad/Level2/ChunkFolder.h"

#include "nexrad/Archives/StoredFiles.h"
#include "nexrad/System/Error.h"

#include <algorithm>
#include <string>
#include <system_error>
#include <tuple>

namespace fs = std::filesystem;

namespace nexrad
{

namespace
{

// '9' stands for any digit, '?' for anything; every other character for itself.
bool Matches(const std::string& text, const std::string& pattern)
{
  return text.size() == pattern.size() &&
         std::equal(text.begin(), text.end(), pattern.begin(),
           [](char found, char wanted)
           {
             const bool digit = found >= '0' && found <= '9';
             return wanted == '9' ? digit : wanted == '?' || found == wanted;
           });
}

} // namespace

std::optional<Chunk> ParseChunkName(const fs::path& path)
{
  const std::string name = path.filename().string();
  const bool kindKnown = !name.empty() && std::string("SIE").find(name.back()) != std::string::npos;
  if (!kindKnown || !Matches(name, "99999999-999999-999-?"))
  {
    return std::nullopt;
  }
  return Chunk{path, name.substr(0, 15), std::stoi(name.substr(16, 3)), name.back()};
}

std::vector<Chunk> ListChunks(const fs::path& folder)
{
  std::vector<Chunk> chunks;
  std::error_code error;
  for (const fs::path& entry : ListFolder(folder, error))
  {
    auto chunk = ParseChunkName(entry);
    if (chunk && KindOf(entry) == StoredKind::File) // opening a pipe would wait for a writer
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

// SPDX-License-Identifier: BSD-3-Clause
#include "nexrad/Level2/Level2File.h"

#include "nexrad/Archives/ForeignFormats.h"
#include "nexrad/Archives/StoredFiles.h"
#include "nexrad/Compression/Container.h"
#include "nexrad/Compression/LdmRecords.h"
#include "nexrad/Level2/FileDecoder.h"
#include "nexrad/Level2/Messages/VolumeHeader.h"
#include "nexrad/Level2/VolumeAssembler.h"
#include "nexrad/System/Error.h"

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <fstream>
#include <string_view>
#include <system_error>
#include <tuple>

namespace fs = std::filesystem;

namespace nexrad
{

namespace
{

RadarVolume ReadChunks(
  const fs::path& folder, const std::vector<Chunk>& chunks, const Level2Options& options)
{
  ChunkDecoder decoder(options);
  // A folder is one volume. Where it holds chunks of older ones too, the newest is wanted.
  const std::string& newest = chunks.back().volume;
  for (const Chunk& chunk : chunks)
  {
    const std::string name = chunk.path.filename().string();
    if (chunk.volume != newest)
    {
      decoder.AddOther(name);
      continue;
    }
    decoder.Begin(chunk.number, name);
    try
    {
      decoder.Decode(ReadStoredBytes(chunk.path, options.maximumFileBytes));
    }
    catch (const Error& error) // one chunk may have vanished since the folder was listed
    {
      decoder.AddDamage(error.what());
    }
  }
  return decoder.VolumeSoFar(folder.string());
}

// The only file of a folder, when it is a Level II file: a chunk that lost its name.
std::optional<fs::path> FindOnlyFile(const fs::path& folder)
{
  std::error_code failure;
  const std::vector<fs::path> files = ListFolder(folder, failure);
  const bool alone = files.size() == 1 && KindOf(files.front()) == StoredKind::File &&
                     LooksLikeLevel2(files.front());
  return alone ? std::optional(files.front()) : std::nullopt;
}

RadarVolume ReadFolder(const fs::path& folder, const Level2Options& options)
{
  const std::vector<Chunk> chunks = ListChunks(folder);
  if (!chunks.empty())
  {
    return ReadChunks(folder, chunks, options);
  }
  if (const auto file = FindOnlyFile(folder))
  {
    return ReadLevel2(*file, options);
  }
  throw Error(
    folder.string() + (FindArchive(folder) ? ": an archive of several files, of which one "
                                             "is to be read: name it behind a slash"
                                           : ": holds no chunk of the real-time feed, "
                                             "named like 20210729-123848-001-S"));
}

} // namespace

std::vector<std::uint8_t> ReadStoredBytes(const fs::path& path, std::size_t cap)
{
  if (const auto member = FindMember(path))
  {
    return member->Start(cap);
  }
  RequireOrdinaryFile(path);
  // A window stays in the processor's cache; a vector that grows would be filled with zeros first.
  std::vector<char> window(std::size_t(1) << 18);
  std::vector<std::uint8_t> bytes;
  bytes.reserve(std::min(static_cast<std::size_t>(StoredSize(path)), cap)); // it may grow
  errno = 0;
  std::ifstream file(path, std::ios::binary);
  while (file && bytes.size() < cap)
  {
    const std::size_t wanted = std::min(window.size(), cap - bytes.size());
    file.read(window.data(), static_cast<std::streamsize>(wanted));
    bytes.insert(bytes.end(), window.data(), window.data() + file.gcount());
  }
  if (!file.is_open() || file.bad())
  {
    throw Error(path.string() + ": cannot read: " + std::strerror(errno != 0 ? errno : EIO));
  }
  return bytes;
}

RadarVolume ReadLevel2(const fs::path& path, const Level2Options& options)
{
  if (KindOf(path) == StoredKind::Folder)
  {
    return ReadFolder(path, options);
  }
  std::vector<std::uint8_t> bytes = ReadStoredBytes(path, options.maximumFileBytes);
  const std::string foreign = NameForeignFormat(ByteView(bytes.data(), bytes.size()));
  if (!foreign.empty())
  {
    throw Error(path.string() + ": " + foreign);
  }
  return DecodeLevel2(std::move(bytes), path.string(), options);
}

bool HoldsMetadataAlone(const RadarVolume& volume)
{
  return volume.sweeps.empty() && volume.damage.empty();
}

RadarVolume DecodeLevel2(
  std::vector<std::uint8_t> bytes, const std::string& name, const Level2Options& options)
{
  VolumeAssembler assembler(options);
  FileDecoder decoder(assembler, options);
  const std::uint64_t size = bytes.size();
  decoder.Decode(std::move(bytes));
  return assembler.Finish(name, size);
}

bool LooksLikeLevel2(const fs::path& path)
{
  const std::vector<std::uint8_t> start = ReadStart(path, VolumeHeader::bytes);
  const ByteView view(start.data(), start.size());
  return IsVolumeHeader(view, 0) || IsLdmRecord(view, 0) ||
         DetectStream(view) != StreamFormat::None;
}

std::string WhyNotLevel2(const fs::path& path)
{
  const std::vector<std::uint8_t> start = ReadStart(path, foreignStartBytes);
  const std::string foreign = NameForeignFormat(ByteView(start.data(), start.size()));
  return foreign.empty() ? "not a Level II file" : foreign;
}

namespace
{

constexpr std::size_t peekedBytes = 4096; // enough of any stream but bzip2 for a header

// The first bytes, which a volume header and the beginning of a record take, out of the streams
// round a file that begins so.
std::vector<std::uint8_t> FirstBytes(std::vector<std::uint8_t> start)
{
  std::vector<Damage> ignored; // the stream is cut, of course
  DecodingBudget budget(
    4 * VolumeHeader::bytes + DecodingBudget::CompressedByteCost * start.size());
  return OpenContainer(std::move(start), budget, ignored).bytes;
}

} // namespace

std::optional<VolumeHeader> PeekVolumeHeader(const fs::path& path)
{
  const bool isFolder = KindOf(path) == StoredKind::Folder;
  const std::vector<Chunk> chunks = isFolder ? ListChunks(path) : std::vector<Chunk>();
  if (isFolder && chunks.empty())
  {
    return std::nullopt;
  }
  const std::vector<std::uint8_t> first =
    FirstBytes(ReadStart(isFolder ? chunks.front().path : path, peekedBytes));
  return ParseVolumeHeader(ByteView(first.data(), first.size()));
}

bool IsGzipOfMessages(const fs::path& path)
{
  std::vector<std::uint8_t> start = ReadStart(path, peekedBytes);
  if (DetectStream(ByteView(start.data(), start.size())) != StreamFormat::Gzip)
  {
    return false;
  }
  const std::vector<std::uint8_t> first = FirstBytes(std::move(start));
  const ByteView bytes(first.data(), first.size());
  return IsVolumeHeader(bytes, 0) && !IsLdmRecord(bytes, VolumeHeader::bytes);
}

std::optional<Chunk> ParseChunkName(const fs::path& path)
{
  constexpr std::string_view pattern = "99999999-999999-999-"; // '9' stands for any digit
  const std::string name = path.filename().string();
  const auto matches = [](char wanted, char found)
  { return wanted == '9' ? found >= '0' && found <= '9' : found == wanted; };
  if (name.size() != pattern.size() + 1 ||
      !std::equal(pattern.begin(), pattern.end(), name.begin(), matches) ||
      std::string_view("SIE").find(name.back()) == std::string_view::npos)
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

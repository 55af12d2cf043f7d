// SPDX-License-Identifier: BSD-3-Clause
#include "nexrad/Level2/Level2File.h"

#include "nexrad/Compression/Container.h"
#include "nexrad/Compression/LdmRecords.h"
#include "nexrad/Level2/ChunkDecoder.h"
#include "nexrad/Level2/ChunkFolder.h"
#include "nexrad/Level2/FileDecoder.h"
#include "nexrad/Level2/Messages/VolumeHeader.h"
#include "nexrad/Level2/VolumeAssembler.h"
#include "nexrad/System/Error.h"
#include "nexrad/System/OrdinaryFile.h"

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>
#include <fstream>
#include <system_error>

namespace fs = std::filesystem;

namespace nexrad
{

namespace
{

// Room for all of a file. Only a hint: a device has no size, and a file may grow.
std::size_t LikelySize(const fs::path& path)
{
  std::error_code failure;
  const std::uintmax_t size = fs::is_regular_file(path, failure) ? fs::file_size(path, failure) : 0;
  return failure ? 0 : static_cast<std::size_t>(size);
}

void DecodeStored(std::vector<std::uint8_t>&& stored, const Level2Options& options,
  VolumeAssembler& assembler, FileDecoder& decoder)
{
  if (stored.size() >= options.maximumFileBytes)
  {
    assembler.AddDamage(stored.size(), FileCapText(options));
  }
  decoder.Decode(std::move(stored));
}

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
  const std::vector<fs::path> files(fs::directory_iterator{folder}, fs::directory_iterator{});
  const bool alone =
    files.size() == 1 && fs::is_regular_file(files.front()) && LooksLikeLevel2(files.front());
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
    folder.string() + ": holds no chunk of the real-time feed, named like 20210729-123848-001-S");
}

} // namespace

std::vector<std::uint8_t> ReadStoredBytes(const fs::path& path, std::size_t cap)
{
  RequireOrdinaryFile(path);
  // A window stays in the processor's cache; a vector that grows would be filled with zeros first.
  std::vector<char> window(std::size_t(1) << 18);
  std::vector<std::uint8_t> bytes;
  bytes.reserve(std::min(LikelySize(path), cap));
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
  std::error_code ignored; // opening the path will say what is wrong with it
  if (fs::is_directory(path, ignored))
  {
    return ReadFolder(path, options);
  }
  return DecodeLevel2(ReadStoredBytes(path, options.maximumFileBytes), path.string(), options);
}

RadarVolume DecodeLevel2(
  std::vector<std::uint8_t> bytes, const std::string& name, const Level2Options& options)
{
  VolumeAssembler assembler(options);
  FileDecoder decoder(assembler, options);
  const std::uint64_t size = bytes.size();
  DecodeStored(std::move(bytes), options, assembler, decoder);
  return assembler.Finish(name, size);
}

bool LooksLikeLevel2(const fs::path& path)
{
  if (!IsOrdinaryFile(path))
  {
    return false;
  }
  std::array<std::uint8_t, VolumeHeader::bytes> start{};
  std::ifstream file(path, std::ios::binary);
  file.read(reinterpret_cast<char*>(start.data()), start.size());
  const ByteView view(start.data(), static_cast<std::size_t>(file.gcount()));
  return IsVolumeHeader(view, 0) || IsLdmRecord(view, 0) ||
         DetectStream(view) != StreamFormat::None;
}

std::optional<VolumeHeader> PeekVolumeHeader(const fs::path& path)
{
  constexpr std::size_t peekedBytes = 4096; // enough of any stream but bzip2 for a header
  std::error_code failure;
  const bool isFolder = fs::is_directory(path, failure);
  const std::vector<Chunk> chunks = isFolder ? ListChunks(path) : std::vector<Chunk>();
  const fs::path first = chunks.empty() ? path : chunks.front().path;
  if (failure || !IsOrdinaryFile(first))
  {
    return std::nullopt;
  }
  std::vector<std::uint8_t> start(peekedBytes);
  std::ifstream file(first, std::ios::binary);
  file.read(reinterpret_cast<char*>(start.data()), static_cast<std::streamsize>(start.size()));
  start.resize(static_cast<std::size_t>(file.gcount()));
  std::vector<Damage> ignored; // the stream is cut, of course
  const PlainFile plain = OpenContainer(std::move(start), VolumeHeader::bytes, ignored);
  return ParseVolumeHeader(ByteView(plain.bytes.data(), plain.bytes.size()));
}

} // namespace nexrad

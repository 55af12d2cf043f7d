// SPDX-License-Identifier: BSD-3-Clause
#include "nexrad/Codec/NxvInput.h"

#include "nexrad/Codec/JsonText.h"
#include "nexrad/Codec/LittleEndian.h"
#include "nexrad/Codec/NxvBricks.h"
#include "nexrad/Codec/ThesisStream.h"
#include "nexrad/Compression/Deflate.h"
#include "nexrad/System/Error.h"

#include <algorithm>
#include <cerrno>
#include <cstring>

namespace nexrad
{

namespace
{

constexpr std::size_t startSize = 8; // magic and header length

std::uint64_t BytesOf(NxvType type)
{
  const NxvVoxelBytes each = NxvVoxelBytes::Of(type);
  return each.planes * each.bytes;
}

// Throws Error for a payload that is too short for its voxels, or for the index of its bricks,
// however well it is compressed: before memory is taken for them.
void CheckExpansion(const NxvArray& array, const GridSpecification& grid)
{
  constexpr std::uint64_t strongest = 1032; // bytes of a byte (zlib's technical details)
  const bool bricks = array.storage == NxvStorage::Bricks;
  const std::uint64_t bytes =
    bricks ? NxvIndexBytes(array, grid.dimensions) : grid.VoxelCount() * BytesOf(array.type);
  const std::uint64_t length = bricks ? array.indexLength : array.length;
  if (array.storage != NxvStorage::RunLength && bytes / strongest > length)
  {
    throw Error("array \"" + Excerpt(array.name) + "\": " + std::to_string(length) +
                " bytes cannot be decompressed to " + std::to_string(bytes));
  }
}

// Checks arrays of a grid that follow each other where `left` bytes of the file are left, and
// takes theirs off.
void CheckLengths(const NxvInput& file, const std::vector<NxvArray>& arrays,
  const GridSpecification& grid, std::uint64_t& left)
{
  for (const NxvArray& array : arrays)
  {
    if (array.length > left)
    {
      RefuseNxv(file.Length() - left, "array \"" + Excerpt(array.name) + "\" should have " +
                                        std::to_string(array.length) + " bytes, the file has " +
                                        std::to_string(left));
    }
    CheckExpansion(array, grid);
    left -= array.length;
  }
}

void CheckLengths(const NxvInput& file, const NxvContent& content)
{
  const GridSpecification& grid = content.header.volume.grid;
  std::uint64_t left = file.Length() - content.payloads;
  CheckLengths(file, content.header.arrays, grid, left);
  for (const NxvLevel& level : content.header.levels)
  {
    CheckLengths(file, level.arrays, CoarserGrid(grid, level.voxels), left);
  }
  if (left != 0)
  {
    RefuseNxv(file.Length() - left, std::to_string(left) + " bytes after the last array");
  }
}

} // namespace

void RefuseNxv(std::uint64_t offset, const std::string& what)
{
  throw Error("byte " + std::to_string(offset) + ": " + what);
}

NxvInput::NxvInput(const std::filesystem::path& path)
{
  std::error_code problem;
  length = std::filesystem::file_size(path, problem);
  if (problem)
  {
    throw Error("cannot be read: " + problem.message());
  }
  stream.open(path, std::ios::binary);
  if (!stream)
  {
    throw Error(std::string("cannot be read: ") + std::strerror(errno));
  }
}

std::uint32_t NxvInput::ChecksumOf(std::uint64_t offset, std::uint64_t size)
{
  std::vector<std::uint8_t> buffer(std::size_t(1) << 16);
  std::uint32_t crc = 0;
  stream.clear();
  stream.seekg(static_cast<std::streamoff>(offset));
  while (size > 0)
  {
    const auto piece = static_cast<std::size_t>(std::min<std::uint64_t>(size, buffer.size()));
    if (!stream.read(reinterpret_cast<char*>(buffer.data()), static_cast<std::streamsize>(piece)))
    {
      RefuseNxv(offset, "cannot be read");
    }
    crc = Crc32(buffer.data(), piece, crc);
    offset += piece;
    size -= piece;
  }
  return crc;
}

std::vector<std::uint8_t> NxvInput::ReadAll(std::uint64_t offset, std::size_t size)
{
  std::vector<std::uint8_t> bytes(size);
  stream.clear();
  stream.seekg(static_cast<std::streamoff>(offset));
  if (!stream.read(reinterpret_cast<char*>(bytes.data()), static_cast<std::streamsize>(size)))
  {
    RefuseNxv(offset, "cannot be read");
  }
  return bytes;
}

NxvContent OpenNxv(NxvInput& file)
{
  if (file.Length() < startSize)
  {
    RefuseNxv(0, "too short for a volume file");
  }
  const std::vector<std::uint8_t> start = file.ReadAll(0, startSize);
  if (std::memcmp(start.data(), "NXV1", 4) != 0)
  {
    RefuseNxv(0, "not a volume file: it must begin with NXV1");
  }
  const std::uint32_t headerLength = LittleEndian(start.data() + 4);
  if (headerLength > NxvLargestHeader || headerLength > file.Length() - startSize)
  {
    RefuseNxv(4, "a header of " + std::to_string(headerLength) + " bytes in a file of " +
                   std::to_string(file.Length()));
  }
  const std::vector<std::uint8_t> text = file.ReadAll(startSize, headerLength);
  NxvContent content;
  try
  {
    content.header = ParseNxvHeader(std::string(text.begin(), text.end()));
  }
  catch (const Error& problem)
  {
    RefuseNxv(startSize, problem.what());
  }
  content.payloads = startSize + headerLength;
  CheckLengths(file, content);
  return content;
}

void CheckNxvPayloads(NxvInput& file, const NxvContent& content)
{
  std::uint64_t offset = content.payloads;
  for (const NxvArray& array : content.header.arrays)
  {
    if (file.ChecksumOf(offset, array.length) != array.crc32)
    {
      RefuseNxv(offset, "array \"" + Excerpt(array.name) + "\": its CRC-32 is wrong");
    }
    offset += array.length;
  }
}

PayloadReader PayloadOf(NxvInput& file, std::uint64_t offset)
{
  return [&file, offset](std::uint64_t from, std::size_t size)
  { return file.ReadAll(offset + from, size); };
}

void ReadArray(NxvInput& file, std::uint64_t offset, const NxvArray& array,
  const GridSpecification& grid, const VoxelBlock& block, std::uint8_t* target,
  const RangeLoop& loop)
{
  if (array.storage == NxvStorage::Bricks)
  {
    ReadBricks(array, grid.dimensions, block, PayloadOf(file, offset), target, loop);
    return;
  }
  const std::size_t size = grid.VoxelCount() * BytesOf(array.type);
  const VoxelBlock all = VoxelBlock::Of(grid);
  std::vector<std::uint8_t> whole(block == all ? 0 : size);
  std::uint8_t* const unpacked = block == all ? target : whole.data();
  const auto stream = file.ReadAll(offset, array.length);
  if (array.storage == NxvStorage::RunLength)
  {
    DecodeRunLength(stream.data(), stream.size(), unpacked, size, loop);
  }
  else if (array.pieces.empty())
  {
    InflateBytes(stream.data(), stream.size(), unpacked, size);
  }
  else
  {
    InflatePieces(stream.data(), array.pieces, array.pieceBytes, unpacked, size, loop);
  }
  if (block != all)
  {
    CopyCommon(NxvVoxelBytes::Of(array.type), all, whole.data(), block, target);
  }
}

} // namespace nexrad

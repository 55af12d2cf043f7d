// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "nexrad/Codec/NxvBricks.h"
#include "nexrad/Codec/NxvHeader.h"
#include "nexrad/Grid/GridSpecification.h"
#include "nexrad/System/Error.h"
#include "nexrad/System/MessageText.h"
#include "nexrad/System/RangeLoop.h"

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

namespace nexrad
{

/// A file that is read in pieces, its length known from the start.
class NxvInput
{
public:
  /// Throws Error when the file cannot be read.
  explicit NxvInput(const std::filesystem::path& path);

  std::uint64_t Length() const { return length; }

  std::vector<std::uint8_t> ReadAll(std::uint64_t offset, std::size_t size);

  /// CRC-32 of `size` bytes from `offset`, which are not all in memory at a time.
  std::uint32_t ChecksumOf(std::uint64_t offset, std::uint64_t size);

private:
  std::uint64_t length = 0;
  std::ifstream stream;
};

/// A volume of a file, and where the payloads of its arrays begin.
struct NxvContent
{
  NxvHeader header;
  std::uint64_t payloads = 0;
};

/// Throws Error that names a place in the file; the file's name comes from whoever knows it.
[[noreturn]] void RefuseNxv(std::uint64_t offset, const std::string& what);

/// Does some work on a file, and names the file in what that throws.
template <typename Work>
auto NamingTheFile(const std::filesystem::path& path, const Work& work)
{
  try
  {
    return work();
  }
  catch (const Error& problem)
  {
    throw FileError(path, problem.what());
  }
}

/// Reads the header, and checks the lengths of all arrays against that of the file.
NxvContent OpenNxv(NxvInput& file);

/// Throws Error when a payload differs from its CRC-32.
void CheckNxvPayloads(NxvInput& file, const NxvContent& content);

/// Unpacks the voxels of a block of an array of a grid: as many bytes as its type and the block
/// have. Of an array in bricks, the others are not read. Throws Error when it is damaged.
void ReadArray(NxvInput& file, std::uint64_t offset, const NxvArray& array,
  const GridSpecification& grid, const VoxelBlock& block, std::uint8_t* target,
  const RangeLoop& loop);

/// Reads parts of the payload of an array that begins at `offset`. `file` must outlive it.
PayloadReader PayloadOf(NxvInput& file, std::uint64_t offset);

} // namespace nexrad

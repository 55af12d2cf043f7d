// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "nexrad/Codec/CodedVolume.h"
#include "nexrad/Codec/NxvHeader.h"
#include "nexrad/Grid/VoxelBlock.h"
#include "nexrad/System/Error.h"
#include "nexrad/System/MessageText.h"
#include "nexrad/System/RangeLoop.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <functional>
#include <string>
#include <vector>

namespace nexrad
{

/// The number that four bytes of an .nxv file stand for.
std::uint32_t LittleEndian(const std::uint8_t* bytes);

/// A file that is read in pieces, its length known from the start.
class NxvInput
{
public:
  /// Throws Error when the file cannot be read.
  explicit NxvInput(const std::filesystem::path& path);

  std::uint64_t Length() const { return length; }

  /// Hands `size` bytes from `offset` on to the receiver, a piece at a time.
  void Read(std::uint64_t offset, std::uint64_t size,
    const std::function<void(const std::uint8_t*, std::size_t)>& receive);

  std::vector<std::uint8_t> ReadAll(std::uint64_t offset, std::size_t size);

private:
  std::uint64_t length = 0;
  std::ifstream stream;
  std::array<char, 64 * 1024> buffer;
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

/// One of the levels of what a file contains, as a volume of its own; 0: the volume itself. Throws
/// Error for a level that the file does not have.
NxvContent LevelOf(NxvContent content, std::size_t level);

/// Throws Error when a payload differs from its CRC-32.
void CheckNxvPayloads(NxvInput& file, const NxvContent& content);

/// Unpacks the voxels of a block of an array of a grid: as many bytes as its type and the block
/// have. Of an array in bricks, the others are not read. Throws Error when it is damaged.
void ReadArray(NxvInput& file, std::uint64_t offset, const NxvArray& array,
  const GridSpecification& grid, const VoxelBlock& block, std::uint8_t* target,
  const RangeLoop& loop);

/// Whether an array of a moment has codes of one byte.
bool HasByteCodes(const NxvArray& array);

/// What its codes stand for in a volume of this fill.
VoxelCodes ByteCodesOf(const NxvArray& array, float fill);

} // namespace nexrad

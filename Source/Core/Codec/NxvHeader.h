// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "nexrad/Codec/NxvLevels.h"
#include "nexrad/Grid/GriddedVolume.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace nexrad
{

/// How the bytes of one array of a volume file are made (Documentation/Formats/nxv.md).
enum class NxvStorage
{
  RunLength, ///< "rle"
  Deflated,  ///< "deflate"
  Bricks     ///< "bricks": boxes of voxels, each deflated or of one value
};

/// What the bytes stand for when they are unpacked.
enum class NxvType
{
  UInt7,  ///< "uint7", one code a voxel
  UInt8,  ///< "uint8", one byte a voxel
  UInt16, ///< "uint16", the lower bytes of all voxels, then the higher bytes of all
  Float32 ///< "float32", little-endian
};

/// One entry of the header's `arrays`.
struct NxvArray
{
  std::string name;
  NxvType type = NxvType::UInt7;
  std::string unit;
  double offset = 0.0;
  double scale = 1.0;
  double fill = 0.0;
  NxvStorage storage = NxvStorage::RunLength;
  std::uint64_t length = 0; ///< bytes of the payload
  std::uint32_t crc32 = 0;  ///< of the payload as it is stored
  /// Of a deflated payload: the unpacked bytes that each of its pieces holds (the last one may hold
  /// fewer), and the bytes that it takes in the payload. Empty: the payload has no pieces.
  std::uint64_t pieceBytes = 0;
  std::vector<std::uint64_t> pieces;
  std::array<int, 3> brick = {0, 0, 0}; ///< voxels of a brick along x, y and z
  std::uint64_t indexLength = 0;        ///< bytes of the payload before the first brick
};

/// The volume in larger voxels: its moments and their states.
struct NxvLevel
{
  VoxelsInOne voxels = {1, 1, 1};
  std::vector<NxvArray> arrays;
};

/// The header of a volume file.
struct NxvHeader
{
  GriddedVolume volume; ///< without values and states
  std::vector<NxvArray> arrays;
  std::vector<NxvLevel> levels; ///< from fine to coarse; their payloads follow those of `arrays`
};

constexpr std::size_t NxvLargestHeader = std::size_t(1) << 20; ///< bytes

/// The JSON text of a header, ending in the CRC-32 of what stands before it.
std::string FormatNxvHeader(const NxvHeader& header);

/// Reads the JSON text. Throws Error (without the file's name) when a key is missing, of the wrong
/// type or out of range, or when the text differs from its CRC-32.
NxvHeader ParseNxvHeader(const std::string& text);

/// Checks the values of an ancillary array of a volume of `sites` sites; `name` as
/// ForEachAncillaryArray has it. Throws Error, naming the voxel, for an age or weight that is
/// negative or not finite, and for a site that the volume does not have.
void CheckAncillaryArray(
  const std::string& name, const std::vector<float>& values, std::size_t sites);
void CheckAncillaryArray(
  const std::string& name, const std::vector<std::uint8_t>& values, std::size_t sites);

} // namespace nexrad

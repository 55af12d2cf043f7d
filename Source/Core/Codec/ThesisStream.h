// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "nexrad/Grid/GriddedVolume.h"
#include "nexrad/System/RangeLoop.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace nexrad
{

/// The thesis's codes of 7 bits for the voxels of a volume of reflectivity: 0 no echo, 127 not
/// scanned, else an echo of as many whole dBZ. An echo that rounds to 0 dBZ or less is no echo; one
/// above 80 dBZ is stored as 80. Range folded and filtered have no codes of their own and become 0.
struct ThesisCode
{
  static constexpr std::uint8_t NoEchoCode = 0;
  static constexpr std::uint8_t LargestCode = 80;
  static constexpr std::uint8_t NotScannedCode = 127;

  /// The state that a code stands for.
  static VoxelState StateOf(std::uint8_t code);
  /// Codes of all voxels. A value that is not a number counts as not scanned. Throws Error when the
  /// volume has not as many values and states as voxels.
  static std::vector<std::uint8_t> EncodeAll(const GriddedVolume& volume);
};

/// The thesis's modified run-length code (Formulas T8): a literal v (0…127) is the byte 0x80 | v; a
/// run of two or more equal v is the byte v and its length as a 32-bit little-endian unsigned
/// integer. Throws Error when a code is above 127.
std::vector<std::uint8_t> EncodeRunLength(const std::vector<std::uint8_t>& codes);

/// Decodes exactly `count` codes into `codes`, of runs of any length. Throws Error, with the offset
/// in the stream, for a run of 0, a stream that ends within a run or too early, a run beyond
/// `count`, or bytes after the last code. The loop decodes several parts of a long stream at a
/// time.
void DecodeRunLength(const std::uint8_t* stream, std::size_t length, std::uint8_t* codes,
  std::size_t count, const RangeLoop& loop = {});

} // namespace nexrad

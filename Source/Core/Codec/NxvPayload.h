// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "nexrad/Codec/CodedVolume.h"
#include "nexrad/Codec/NxvInput.h"
#include "nexrad/System/RangeLoop.h"

#include <cstddef>
#include <cstdint>

namespace nexrad
{

/// Inflates an array that must give exactly `size` bytes into `target`. Throws Error.
void ReadDeflated(NxvInput& file, std::uint64_t offset, const NxvArray& array, std::uint8_t* target,
  std::size_t size, const RangeLoop& loop);

/// Whether an array of a moment has codes of one byte.
bool HasByteCodes(const NxvArray& array);

/// Unpacks such an array. Throws Error unless it gives exactly `voxels` codes.
void ReadByteCodes(NxvInput& file, std::uint64_t offset, const NxvArray& array, std::uint8_t* codes,
  std::size_t voxels, const RangeLoop& loop);

/// What its codes stand for in a volume of this fill.
VoxelCodes ByteCodesOf(const NxvArray& array, float fill);

} // namespace nexrad

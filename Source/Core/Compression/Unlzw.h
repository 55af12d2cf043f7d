// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "nexrad/Compression/BigEndian.h"
#include "nexrad/Compression/OffsetMap.h"

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace nexrad
{

/// What came out of a compressed stream, as far as it could be read.
struct Unpacked
{
  std::vector<std::uint8_t> bytes;
  OffsetMap offsets;               ///< from `bytes` to the compressed stream
  std::string problem;             ///< one line; empty when the stream was whole
  std::uint64_t problemOffset = 0; ///< in the compressed stream
};

/// Decompresses the format of the Unix program compress (.Z): LZW with codes of 9 to 16 bits,
/// lowest bit first. Stops with a problem at the first code that no encoder could have written, and
/// when `maximumBytes` came out.
Unpacked Unlzw(ByteView stored, std::size_t maximumBytes);

} // namespace nexrad

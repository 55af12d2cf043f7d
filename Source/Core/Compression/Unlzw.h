// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "nexrad/Compression/BigEndian.h"
#include "nexrad/Compression/OffsetMap.h"

#include <cstddef>

namespace nexrad
{

/// Decompresses the format of the Unix program compress (.Z): LZW with codes of 9 to 16 bits,
/// lowest bit first. Stops with a problem at the first code that no encoder could have written, and
/// when `maximumBytes` came out.
Unpacked Unlzw(ByteView stored, std::size_t maximumBytes);

} // namespace nexrad

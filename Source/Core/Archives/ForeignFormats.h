// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "nexrad/Compression/BigEndian.h"

#include <cstddef>
#include <string>

namespace nexrad
{

/// So many first bytes tell a format.
constexpr std::size_t foreignStartBytes = 64;

/// What a file is, by its first bytes, when it has a well-known format that is not read here:
/// "a zip archive; unpack it first". "" for any other file.
std::string NameForeignFormat(ByteView start);

} // namespace nexrad

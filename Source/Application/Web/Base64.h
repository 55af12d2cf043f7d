// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace nexrad::application
{

/// Bytes as text of the letters of base64 (RFC 4648, section 4), without line breaks.
std::string FormatBase64(const std::vector<std::uint8_t>& bytes);

} // namespace nexrad::application

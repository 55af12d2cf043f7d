// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <vector>

namespace nexrad
{

/// The number that four bytes of an .nxv file stand for.
inline std::uint32_t LittleEndian(const std::uint8_t* bytes)
{
  return bytes[0] | static_cast<std::uint32_t>(bytes[1]) << 8 |
         static_cast<std::uint32_t>(bytes[2]) << 16 | static_cast<std::uint32_t>(bytes[3]) << 24;
}

/// Adds the four bytes of a number.
inline void AppendLittleEndian(std::uint32_t word, std::vector<std::uint8_t>& to)
{
  for (unsigned shift = 0; shift < 32; shift += 8)
  {
    to.push_back(static_cast<std::uint8_t>(word >> shift));
  }
}

} // namespace nexrad

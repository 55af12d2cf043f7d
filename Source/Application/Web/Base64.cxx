// SPDX-License-Identifier: BSD-3-Clause
#include "Web/Base64.h"

#include <algorithm>
#include <cstddef>

namespace nexrad::application
{

std::string FormatBase64(const std::vector<std::uint8_t>& bytes)
{
  constexpr char letters[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  text.reserve((bytes.size() + 2) / 3 * 4);
  for (std::size_t first = 0; first < bytes.size(); first += 3)
  {
    const std::size_t count = std::min<std::size_t>(3, bytes.size() - first);
    std::uint32_t word = 0;
    for (std::size_t i = 0; i < 3; ++i)
    {
      word = word << 8 | (i < count ? bytes[first + i] : 0U);
    }
    for (std::size_t i = 0; i < 4; ++i)
    {
      text += i <= count ? letters[word >> (18 - 6 * i) & 63U] : '=';
    }
  }
  return text;
}

} // namespace nexrad::application

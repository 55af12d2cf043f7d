// SPDX-License-Identifier: BSD-3-Clause
#include "nexrad/System/Error.h"

#include <cstddef>

namespace nexrad
{

std::string Shortened(const std::string& message)
{
  constexpr std::size_t most = 300;
  if (message.size() <= most)
  {
    return message;
  }
  const auto continues = [&message](std::size_t byte)
  { return (static_cast<unsigned char>(message[byte]) & 0xC0U) == 0x80U; };
  std::size_t end = most;
  while (end > 0 && continues(end)) // within a letter of several bytes (UTF-8)
  {
    --end;
  }
  return message.substr(0, end) + "…";
}

} // namespace nexrad

// SPDX-License-Identifier: BSD-3-Clause
#include "Web/Base64.h"

#include <vtksys/Base64.h>

namespace nexrad::application
{

std::string FormatBase64(const std::vector<std::uint8_t>& bytes)
{
  std::string text((bytes.size() + 2) / 3 * 4, '=');
  vtksysBase64_Encode(bytes.data(), bytes.size(), reinterpret_cast<unsigned char*>(text.data()), 0);
  return text;
}

} // namespace nexrad::application

// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <string>

namespace nexrad::application
{

/// "1 ray", "0 rays", "360 rays": for nouns whose plural takes an s.
inline std::string Counted(std::uintmax_t count, const std::string& noun)
{
  return std::to_string(count) + " " + noun + (count == 1 ? "" : "s");
}

} // namespace nexrad::application

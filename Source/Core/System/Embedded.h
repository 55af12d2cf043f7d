// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>

/// Files of Data/ that are compiled in (CMake/NexradEmbed.cmake).
namespace nexrad::embedded
{

extern const unsigned char radarSites[];
extern const std::size_t radarSitesSize;

} // namespace nexrad::embedded

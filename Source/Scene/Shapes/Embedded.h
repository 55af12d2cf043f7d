// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>

/// Bytes of files of the folder Data that are compiled into the scene (nexrad_embed).
namespace nexrad::embedded
{

#define NEXRAD_EMBEDDED(symbol)                                                                    \
  extern const unsigned char symbol[];                                                             \
  extern const std::size_t symbol##Size;
NEXRAD_EMBEDDED(boldLetters)
NEXRAD_EMBEDDED(elevations)
NEXRAD_EMBEDDED(letters)
NEXRAD_EMBEDDED(mapAreas)
NEXRAD_EMBEDDED(mapLines)
NEXRAD_EMBEDDED(mapNames)
NEXRAD_EMBEDDED(mapTowns)
NEXRAD_EMBEDDED(reflectivityColours)
#undef NEXRAD_EMBEDDED

} // namespace nexrad::embedded

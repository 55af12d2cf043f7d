// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>

namespace nexrad::application
{

/// What the thesis measured for one size of volume on a Pentium 4 of 3.2 GHz (Formulas T, tables
/// 4.1 and 4.4).
struct ThesisFigures
{
  std::array<int, 3> dimensions;
  double secondsPerVolume; ///< from the radars' files to the merged volume
  double minutesPerDay;    ///< of more than 280 volumes
  double bytesAfter;       ///< run-length coded; one byte a voxel before
  double savedPercent;     ///< by that
};

constexpr std::array<ThesisFigures, 3> ThesisTables = {{
  {{128, 128, 64}, 6.0, 30.0, 10.2 * 1024, 99.1},
  {{256, 256, 128}, 8.0, 45.0, 54.0 * 1024, 99.34},
  {{512, 512, 256}, 12.0, 57.0, 308.4 * 1024, 99.53},
}};

/// The row of these dimensions; nullptr when the thesis has none.
inline const ThesisFigures* FindThesisFigures(const std::array<int, 3>& dimensions)
{
  for (const ThesisFigures& figures : ThesisTables)
  {
    if (figures.dimensions == dimensions)
    {
      return &figures;
    }
  }
  return nullptr;
}

} // namespace nexrad::application

// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>

namespace nexrad::application
{

/// What the thesis measured for one size of volume on a Pentium 4 of 3.2 GHz with a Quadro FX 3500
/// (Formulas T, tables 4.1, 4.2 and 4.4).
struct ThesisFigures
{
  std::array<int, 3> dimensions;
  double secondsPerVolume; ///< from the radars' files to the merged volume
  double minutesPerDay;    ///< of more than 280 volumes
  double bytesAfter;       ///< run-length coded; one byte a voxel before
  double savedPercent;     ///< by that
  const char* readMs;      ///< t1: a volume from the disk, decompressed, ms
  double uploadMs;         ///< t2: into the texture, ms
  double drawMs;           ///< t3: one frame of 256 slices, 796×532, ms
  double totalMs;
};

constexpr std::array<ThesisFigures, 3> ThesisTables = {{
  {{128, 128, 64}, 6.0, 30.0, 10.2 * 1024, 99.1, "<1", 3.8, 122.0, 126.0},
  {{256, 256, 128}, 8.0, 45.0, 54.0 * 1024, 99.34, "8", 24.0, 122.0, 154.0},
  {{512, 512, 256}, 12.0, 57.0, 308.4 * 1024, 99.53, "100", 131.0, 126.0, 357.0},
}};

/// Frames a second by number of slices (table 4.3), 1 / (t1 + t2 + t3), for the sizes of
/// ThesisTables.
struct ThesisFrameRates
{
  int slices;
  std::array<double, 3> framesPerSecond;
};

constexpr std::array<ThesisFrameRates, 5> ThesisFrameRateTable = {{
  {64, {20.0, 18.0, 4.0}},
  {128, {15.0, 12.0, 4.0}},
  {256, {8.0, 8.0, 3.5}},
  {512, {5.0, 5.0, 2.5}},
  {1024, {3.0, 3.0, 1.5}},
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

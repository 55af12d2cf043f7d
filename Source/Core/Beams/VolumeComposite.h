// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "nexrad/Model/Time.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace nexrad
{

struct BeamSweep;

/// What a volume holds above each place, whatever the tilt: sectors of 1° of azimuth by rings of
/// 2 km along the ground. For what looks for echo without looking at each gate: the picture in
/// which motion is found, and the search for columns without any.
struct VolumeComposite
{
  static constexpr int Sectors = 360;
  static constexpr float RingWidth = 2000.0F; ///< m along the ground

  enum class Cell : std::uint8_t
  {
    NotScanned,
    NoEcho,
    Held ///< a gate holds something else: a value, or the mark of a folded or unsampled gate
  };

  /// How much echo one sweep has.
  struct Tilt
  {
    float elevation = 0.0F; ///< degrees
    double echo = 0.0;      ///< its part of the sum
  };

  int rings = 0;
  std::vector<Cell> cells; ///< rings × sectors, rings fastest
  std::vector<std::uint8_t>
    tops; ///< ElevationCode of the highest sweep that makes the cell Held; else 0
  std::vector<float> values; ///< strongest echo in the moment's unit, at least 0; else 0
  float widestGap = 0.0F;    ///< degrees between neighbouring rays that are interpolated between
  double echoTime = 0.0;     ///< s since 1970, mean over the echo, each gate by its value
  double echo = 0.0;         ///< sum of the values in that mean; 0 without echo
  std::vector<Tilt> tilts;   ///< of the sweeps, in the order scanned

  std::size_t Index(int sector, int ring) const
  {
    return static_cast<std::size_t>(sector) * static_cast<std::size_t>(rings) +
           static_cast<std::size_t>(ring);
  }
  std::size_t MemoryBytes() const
  {
    return values.size() * (sizeof(float) + sizeof(Cell) + 1) + tilts.size() * sizeof(Tilt);
  }
};

/// An elevation, degrees from −10 to 90, as a number above 0 that does not fall where it rises.
inline std::uint8_t ElevationCode(float elevation)
{
  return static_cast<std::uint8_t>(std::clamp(2.0F * (elevation + 10.0F), 0.0F, 254.0F) + 1.0F);
}

/// The composite of sweeps of one moment.
VolumeComposite MakeComposite(const std::vector<BeamSweep>& sweeps);

/// The composite of the first sweep of the lowest tilt alone; of no sweep without any.
VolumeComposite MakeLowestComposite(const std::vector<BeamSweep>& sweeps);

} // namespace nexrad

// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "nexrad/Geometry/Beam.h"

#include <cstddef>
#include <limits>
#include <vector>

namespace nexrad
{

struct BeamSweep;

/// The reflectivity of one tilt as means over cells of 1° of azimuth by 1 km along the ground, dBZ,
/// in which no echo counts as 0 dBZ. A mean of 0 dBZ is one without echo.
class TiltMeans
{
public:
  static constexpr std::size_t Sectors = 360;
  static constexpr std::size_t Rings = 300;
  static constexpr double RingWidth = 1000.0; ///< m

  TiltMeans(const BeamSweep& sweep, const BeamModel& beam);

  float Elevation() const { return elevation; }
  /// Not-a-number where half of the gates or more were not measured. `place` is the ground distance
  /// in rings; between the rings' middles the means are interpolated.
  float At(std::size_t sector, float place) const
  {
    const float from = place - 0.5F;
    if (!(from >= 0.0F && from < static_cast<float>(ringCount) - 1.0F))
    {
      return std::numeric_limits<float>::quiet_NaN();
    }
    const auto ring = static_cast<std::size_t>(from);
    const float* row = means.data() + sector * ringCount + ring;
    return row[0] + (from - static_cast<float>(ring)) * (row[1] - row[0]);
  }
  /// Whether a ring about a place is the one of the tilt's last gate or farther.
  bool Ends(float place) const { return place + 0.5F >= last; }

  /// Ground distances, in rings, between which At may be above 0 dBZ; from infinity to 0 where it
  /// is so nowhere.
  struct Span
  {
    float begin = std::numeric_limits<float>::infinity();
    float end = 0.0F;
  };
  Span EchoIn(std::size_t sector) const { return echoes[sector]; }
  bool HasEcho(std::size_t sector) const { return echoes[sector].end > 0.0F; }

private:
  float elevation;           // degrees
  float last = 0.0F;         // ring of the last gate
  std::size_t ringCount = 0; // to the last one with gates; farther ones are not known
  std::vector<float> means;  // rings fastest
  std::vector<Span> echoes;  // of each sector
};

/// How much the echo of a volume lies in layers, for each gap between neighbouring tilts (Formulas
/// G12): from how much the two tilts differ straight above each other and at equal height, summed
/// over 35° of azimuth, 36 km along the ground, and the gaps beside.
class LayerShares
{
public:
  static constexpr double RingWidth = 4.0 * TiltMeans::RingWidth; ///< m
  static constexpr std::size_t Rings = TiltMeans::Rings / 4;

  /// Tilts in ascending order.
  LayerShares(const std::vector<TiltMeans>& tilts, const BeamModel& beam);

  /// The shares over a degree of azimuth, by ring along the ground: 0 where echo continues straight
  /// up, or where there is none, to 1 where it lies in layers.
  const float* Row(std::size_t gap, std::size_t sector) const;

private:
  std::vector<std::vector<float>> shares; // of each gap, cells of 5° × 4 km
};

} // namespace nexrad

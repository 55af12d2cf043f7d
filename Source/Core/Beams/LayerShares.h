// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "nexrad/Beams/TiltMeans.h"

#include <cstddef>
#include <vector>

namespace nexrad
{

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

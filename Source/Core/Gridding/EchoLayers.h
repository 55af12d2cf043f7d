// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Gridding/SiteGeometry.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace nexrad
{

struct BeamSweep;

/// Where the echo of one volume lies in layers, for each gap between neighbouring tilts: how much
/// better the reflectivity of the two tilts agrees at equal height than straight above each other
/// (Formulas G12). Cells of 5° of azimuth by 4 km along the ground.
class EchoLayers
{
public:
  /// The gap between two neighbouring tilts.
  struct Gap
  {
    float lower = 0.0F;               ///< degrees, elevation of the lower tilt
    float upper = 0.0F;               ///< degrees, of the upper tilt
    std::vector<std::uint8_t> shares; ///< 255 × the share, rings × sectors, rings fastest
  };

  EchoLayers() = default;
  /// The layers in sweeps of reflectivity, dBZ; `effectiveRadius` in m, of the beams' path.
  EchoLayers(const std::vector<BeamSweep>& sweeps, double effectiveRadius);

  /// The gap of this volume that holds an elevation, degrees; nullptr when it lies in none.
  const Gap* FindGap(float elevation) const;

  /// 0 where echo continues straight up, or where there is none, to 1 where it lies in layers.
  float ShareAt(const Gap& gap, const ColumnDirection& column) const;

  std::size_t MemoryBytes() const;

private:
  std::size_t rings = 0;
  float ringsPerTangent = 0.0F; // rings in a unit of halfTangent
  std::vector<Gap> gaps;        // ascending
};

} // namespace nexrad

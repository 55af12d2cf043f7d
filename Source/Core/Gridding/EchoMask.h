// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Gridding/SiteGeometry.h"
#include "Gridding/VolumeComposite.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace nexrad
{

/// The places about which one radar may have seen something but no echo, on any tilt and in any of
/// some volumes. Errs to one side: where it holds nothing, every look at a gate within `distance` m
/// finds no echo or was not scanned.
class EchoMask
{
public:
  /// An empty mask holds everything.
  EchoMask() = default;
  /// `effectiveRadius` in m, of the beams' path; `distance` in m, at least 0.
  EchoMask(
    const std::vector<const VolumeComposite*>& composites, double effectiveRadius, double distance);

  bool Holds(const ColumnDirection& column) const
  {
    const auto ring = static_cast<std::size_t>(column.halfTangent * ringsPerTangent);
    return ring >= rings ? near.empty()
                         : near[static_cast<std::size_t>(column.azimuth) * rings + ring] != 0;
  }

private:
  void Widen(double distance, float widestGap);
  void WidenRings(int by);
  void WidenSectors(std::size_t ring, int by);

  std::size_t rings = 0;
  float ringsPerTangent = 0.0F;
  std::vector<std::uint8_t> near; // rings × sectors, rings fastest
};

} // namespace nexrad

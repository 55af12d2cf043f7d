// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "nexrad/Beams/VolumeComposite.h"
#include "nexrad/Grid/SiteGeometry.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace nexrad
{

/// The places about which any of some volumes of one radar has gates other than no echo, and up to
/// which tilt. It may name too many places, never too few: above the elevation that it gives for a
/// column, every gate within `distance` m is no echo or was not scanned.
class EchoMask
{
public:
  /// An empty mask excludes nothing: it gives the highest elevation everywhere.
  EchoMask() = default;
  /// `effectiveRadius` in m, of the beams' path; `distance` in m, at least 0.
  EchoMask(
    const std::vector<const VolumeComposite*>& composites, double effectiveRadius, double distance);

  /// ElevationCode of the highest sweep that has something about a column; 0 for none.
  std::uint8_t TopOver(const ColumnDirection& column) const
  {
    const auto ring = static_cast<std::size_t>(column.halfTangent * ringsPerTangent);
    if (ring >= rings)
    {
      return tops.empty() ? 255 : 0;
    }
    return tops[static_cast<std::size_t>(column.azimuth) * rings + ring];
  }

private:
  // The cells from `first` on, `stride` apart.
  void WidenLine(std::size_t first, std::size_t stride, std::size_t count, int by, bool circle);

  std::size_t rings = 0;
  float ringsPerTangent = 0.0F;
  std::vector<std::uint8_t> tops; // rings × sectors, rings fastest
};

} // namespace nexrad

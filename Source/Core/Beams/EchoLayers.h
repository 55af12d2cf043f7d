// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "nexrad/Geometry/Beam.h"
#include "nexrad/Grid/SiteGeometry.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

namespace nexrad
{

struct BeamSweep;

/// What layers of echo change between the tilts of one volume of reflectivity (Formulas G12): where
/// the tilts agree better at equal height than straight above each other, the echo between them
/// is taken from equal height. Made once for a volume, in cells of 1° of azimuth by 2 km along the
/// ground.
class EchoLayers
{
public:
  /// What is changed in one gap over a column.
  struct Changes
  {
    /// dB, to be added to what the interpolation in elevation gives (Formulas G11) at each quarter
    /// of the way from a tilt to the next; nothing is added at the tilts.
    std::array<float, 5> atQuarters{};
    /// dBZ; what is added raises no echo above it: the strongest V nearby, and 1 dB.
    float most = 0.0F;

    bool Any() const { return atQuarters != std::array<float, 5>{}; }
    /// What `value`, dBZ, becomes `share` of the way, 0…1, from the lower tilt to the upper one.
    float Apply(float value, float share) const
    {
      const float place = 4.0F * share;
      const auto before = std::min(static_cast<std::size_t>(place), std::size_t(3));
      const float changed =
        value + atQuarters[before] +
        (place - static_cast<float>(before)) * (atQuarters[before + 1] - atQuarters[before]);
      return changed > value ? std::max(value, std::min(changed, most)) : changed;
    }
  };
  /// Volumes have fewer gaps between tilts; what lies above is not changed.
  static constexpr std::size_t MostGaps = 32;
  static constexpr std::size_t Rings = 150; ///< of 2 km
  static constexpr float Precision = 0.5F;  ///< dB, of the changes

  EchoLayers() = default;
  /// The sweeps are in dBZ. `beamWidth` in degrees; `ceiling` in m above the antenna, above which
  /// there is no weather (Formulas G4).
  EchoLayers(
    const std::vector<BeamSweep>& sweeps, double beamWidth, const BeamModel& beam, double ceiling);

  /// The number of the gap between two neighbouring tilts, degrees; −1 when the volume has none.
  int FindGap(float lower, float upper) const;

  /// Bits for the gaps in which something is changed in a direction, or within 6 km and 3° of it.
  std::uint32_t GapsAt(const ColumnDirection& direction) const
  {
    const std::size_t cell = this->CellAt(direction);
    return cell < marks.size() ? marks[cell] : 0;
  }
  /// The cell of `Marks` in which a direction lies; more than there are beyond all cells.
  std::size_t CellAt(const ColumnDirection& direction) const
  {
    const auto ring = static_cast<std::size_t>(direction.halfTangent * ringsPerTangent);
    return ring < Rings ? static_cast<std::size_t>(direction.azimuth) * Rings + ring
                        : std::numeric_limits<std::size_t>::max();
  }
  /// GapsAt by cell; empty when nothing is changed.
  const std::vector<std::uint32_t>& Marks() const { return marks; }

  /// The four cells about a direction.
  struct Place
  {
    std::size_t first = 0;  ///< nearest sector before
    std::size_t second = 0; ///< nearest sector after
    std::size_t cell = 0;   ///< of the nearer ring, place of its changes in the row of a sector
    float along = 0.0F;     ///< how far on the way to the next ring, 0…1
    float across = 0.0F;    ///< and from one sector to the other
  };
  Place FindPlace(const ColumnDirection& direction) const;
  /// Adds `weight` times the changes in a gap.
  void Add(int gap, const Place& place, float weight, Changes& to) const;

  std::size_t MemoryBytes() const;

private:
  struct Gap
  {
    float lower = 0.0F; // degrees
    float upper = 0.0F;
    std::vector<std::uint32_t> rows;  // where each sector's changes begin; empty without any
    std::vector<std::int8_t> changes; // of each ring four: the changes in Precision, and the most
                                      // in dBZ. The first row is of sectors without any

    // The row of a sector, which it has from now on.
    std::int8_t* RowOf(std::size_t sector);
  };

  float ringsPerTangent = 0.0F;     // rings in a unit of halfTangent
  std::vector<Gap> gaps;            // ascending
  std::vector<std::uint32_t> marks; // of GapsAt
};

} // namespace nexrad

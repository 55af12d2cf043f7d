// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Geometry/Beam.h"
#include "Gridding/SiteGeometry.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
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
  /// dB, to be added to what the interpolation in elevation gives (Formulas G11) at a quarter, half
  /// and three quarters of the way from a tilt to the next; nothing is added at the tilts.
  using Changes = std::array<float, 3>;
  /// Volumes have fewer gaps between tilts; what lies above is not changed.
  static constexpr std::size_t MostGaps = 32;

  EchoLayers() = default;
  /// The sweeps are in dBZ. `beamWidth` in degrees; `ceiling` in m above the antenna, above which
  /// there is no weather (Formulas G4).
  EchoLayers(
    const std::vector<BeamSweep>& sweeps, double beamWidth, const BeamModel& beam, double ceiling);

  /// What is `share` of the way, 0…1, through a gap of these changes, dB.
  static float ChangeAt(const Changes& changes, float share)
  {
    const float place = 4.0F * share;
    const auto before = static_cast<std::size_t>(std::clamp(place, 0.0F, 3.0F));
    const float lower = before > 0 ? changes[before - 1] : 0.0F;
    const float upper = before < 3 ? changes[before] : 0.0F;
    return lower + (place - static_cast<float>(before)) * (upper - lower);
  }

  /// The number of the gap between two neighbouring tilts, degrees; −1 when the volume has none.
  int FindGap(float lower, float upper) const;

  /// A bit for each gap in which something is changed in a direction, or within 6 km and 3° of it.
  std::uint32_t GapsAt(const ColumnDirection& direction) const;

  /// Adds `weight` times the changes in a gap.
  void Add(int gap, const ColumnDirection& direction, float weight, Changes& to) const;

  std::size_t MemoryBytes() const;

private:
  struct Gap
  {
    float lower = 0.0F; // degrees
    float upper = 0.0F;
    std::vector<std::int8_t> changes; // half dB; rings × sectors × 3, the three fastest; or empty
  };
  void MarkGaps();

  float ringsPerTangent = 0.0F;     // rings in a unit of halfTangent
  std::vector<Gap> gaps;            // ascending
  std::vector<std::uint32_t> marks; // of GapsAt
};

} // namespace nexrad

// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Geometry/Beam.h"

#include <cstddef>
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
  float At(std::size_t sector, float place) const;
  /// Whether a ring about a place is the one of the tilt's last gate or farther.
  bool Ends(float place) const { return place + 0.5F >= last; }
  /// False when no mean of a sector is above 0 dBZ.
  bool HasEcho(std::size_t sector) const { return echoes[sector]; }

private:
  float elevation;          // degrees
  float last;               // ring of the last gate
  std::vector<float> means; // rings fastest
  std::vector<bool> echoes; // of each sector
};

} // namespace nexrad

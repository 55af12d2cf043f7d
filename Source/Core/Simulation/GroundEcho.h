// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <vector>

namespace nexrad
{

/// A direction and a slant range as an antenna sees them.
struct SeenPlace
{
  double azimuth = 0.0;   ///< degrees
  double elevation = 0.0; ///< degrees
  double range = 0.0;     ///< m
};

/// Echo of the ground about one radar: which places have it depends on the radar's key alone, so
/// that it stands still from ray to ray and from volume to volume. Targets fill cells of 1° and
/// 250 m; neighbouring cells are independent, and differ by 8 dB (one standard deviation).
class GroundEcho
{
public:
  /// `beamWidth` in degrees, between half-power points of the one-way pattern.
  GroundEcho(std::uint64_t radarKey, double beamWidth);

  /// Reflectivity in dBZ of fixed targets: many within 15 km of the radar, and on three ridges 25
  /// to 80 km away. The targets rise to 0.4° of elevation; above them the echo falls with the
  /// two-way pattern, to side lobes 45 dB below. -infinity where there is no target.
  double Clutter(const SeenPlace& place) const;

  /// Reflectivity in dBZ of three patches of ground 50 to 130 km away that the air bends the lowest
  /// beam to. It falls by 90 dB a degree above 0.5° of elevation. -infinity outside the patches.
  double AnomalousPropagation(const SeenPlace& place) const;

private:
  // A ridge, or a patch of ground: its middle and its half extent.
  struct Area
  {
    double azimuth;    // degrees
    double halfWidth;  // degrees
    double range;      // m
    double halfLength; // m
    double slope;      // m of range a degree of azimuth
  };

  std::uint64_t key;
  double width;
  std::vector<Area> ridges;
  std::vector<Area> patches;

  /// Squared distance of a place from the middle of an area, 1 at its edge.
  static double SquaredDistance(const Area& area, const SeenPlace& place);
  /// What the beam loses of a target, dB.
  double PatternLoss(double elevation, double target) const;
};

} // namespace nexrad

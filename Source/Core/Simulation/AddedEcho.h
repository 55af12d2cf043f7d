// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "nexrad/Simulation/BeamTrace.h"
#include "nexrad/Simulation/EchoKind.h"
#include "nexrad/Simulation/ScanStrategy.h"
#include "nexrad/Simulation/StormWind.h"

#include <cstdint>
#include <optional>
#include <set>
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

/// Which ray of a volume it is.
struct RayPlace
{
  int cut = 0;           ///< number of the cut, from 1
  int index = 0;         ///< of the ray in its cut, from 0
  int rays = 1;          ///< of the cut
  std::uint64_t key = 0; ///< of the ray's noise (CounterNoise)
};

/// Echo that is not weather, added to the rays of one radar. Each kind can be had by itself.
///
/// - clutter and anomalous propagation: GroundEcho, 1.5 dB of change from ray to ray
/// - biological: up to 20 dBZ, less 14 dB at 1.2 km above the antenna and with the square of the
///   height, up to 2.5 km; stronger by 3 dB across the flight than along it
/// - sun: the sun stands at 268° of azimuth and 0.9° of elevation; its noise has one power at all
///   ranges, so that the reflectivity grows with 20·log10 of the range: −1 dBZ at 50 km in the
///   middle, less 12 dB by (distance/beam width)²
/// - interference: one ray of each cut below 5°, at another azimuth in each; 12 dBZ at 50 km
/// - test pattern: two neighbouring rays of every third cut, all gates of which hold one value
/// - speckle: one gate of 1250, 4 to 24 dB above the weakest echo of an ordinary radar
class AddedEcho
{
public:
  /// `radarKey` is the radar's own, whatever the volume; `beamWidth` in degrees.
  AddedEcho(const std::set<EchoKind>& kinds, std::uint64_t radarKey, double beamWidth);

  bool Any() const { return !added.empty(); }

  /// Adds the echoes to a ray that the beam points along: `reflectivity` in dBZ (-infinity: none)
  /// is that of the sum of Z; `kinds` is what the strongest of a gate comes from.
  void AddTo(const BeamTrace& beam, const RayPlace& place, const GateLayout& layout,
    std::vector<double>& reflectivity, std::vector<EchoKind>& kinds) const;

  /// Whether the receiver's test pattern replaces a ray.
  bool IsTestPattern(const RayPlace& place) const;

  /// How birds and insects fly through the air, m/s: to the north-north-east.
  static WindVector OwnFlight() { return {3.0, 9.0}; }

private:
  std::set<EchoKind> added;
  std::uint64_t key;
  double width;
  GroundEcho ground;

  double Biological(const BeamTrace& beam, const SeenPlace& place) const;
  double Sun(const SeenPlace& place) const;
  bool IsInterference(const BeamTrace& beam, const RayPlace& place) const;
  double ValueOf(EchoKind kind, const BeamTrace& beam, const RayPlace& ray, const SeenPlace& place,
    std::uint64_t gate) const;
};

} // namespace nexrad

// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "nexrad/Polar/PolarVolume.h"

#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

namespace nexrad
{

/// Which sweep of `after` answers to each sweep of `before` (Formulas T4): one of nearly the same
/// elevation (within 0.3°). Of several, one with the same elevation number; then the one that
/// is as many repetitions of its elevation into the volume; then the nearest elevation. Empty where
/// there is none.
std::vector<std::optional<std::size_t>> PairSweeps(
  const PolarVolume& before, const PolarVolume& after);

/// Finds the ray of a sweep that points in a direction.
class RayFinder
{
public:
  /// The sweep is not owned and must outlive the finder.
  explicit RayFinder(const PolarSweep& sweep);

  /// The ray with the azimuth nearest to `azimuth` degrees; empty when none is within `tolerance`
  /// degrees. Of two equally near, the one of smaller azimuth.
  std::optional<std::size_t> Nearest(double azimuth, double tolerance) const;

private:
  std::vector<std::pair<double, std::size_t>> rays; // azimuth 0…360 and index, ascending
};

/// The rays of a sweep that are rays of its cut, by their indices, ascending: those that do not
/// stray from it (Formulas Q7). None where most rays stray (HasElevation): a scan in elevation has
/// no tilt. `beamWidth` in degrees.
std::vector<std::size_t> FindRaysOfCut(const PolarSweep& sweep, double beamWidth);

/// Of REF, leaves out of `rays`, indices in a sweep of a volume, those of the Doppler half of a
/// split cut in whose directions its surveillance half has rays of its cut. The Doppler half is a
/// contiguous Doppler cut after a surveillance or batch cut at the same tilt, with nothing but
/// other cuts at that tilt between them. A terminal radar's cuts without ambiguity resolution are
/// none: it repeats the lowest one each minute for its reflectivity. `beamWidth` in degrees.
void LeaveOutSeenTwice(
  const PolarVolume& volume, std::size_t sweep, double beamWidth, std::vector<std::size_t>& rays);

} // namespace nexrad

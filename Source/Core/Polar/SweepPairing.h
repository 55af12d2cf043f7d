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

} // namespace nexrad

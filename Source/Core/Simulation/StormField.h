// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Geometry/GridSpecification.h"
#include "Model/Time.h"

#include <array>
#include <cstdint>
#include <vector>

namespace nexrad
{

/// The synthetic storm day: an analytic reflectivity field of several supercells that are born,
/// move, grow and decay over Missouri and Illinois on 2006-03-12. A closed form, so that every
/// stage can be held against the truth anywhere at any time. All data made from it are SYNTHETIC.
class StormField
{
public:
  /// The day depends on the seed alone.
  explicit StormField(std::uint32_t seed = 1);

  /// Reflectivity in dBZ at a point; -infinity where there is no echo at all. Height in m above
  /// mean sea level.
  double Reflectivity(double longitude, double latitude, double height, Time time) const;

  /// Mean over the box of a voxel (mean of dBZ floored at `floor`, over a fixed lattice of
  /// samples), dBZ.
  double MeanReflectivity(const GridSpecification& grid, const std::array<int, 3>& voxel, Time time,
    double floor = 0.0) const;

private:
};

} // namespace nexrad

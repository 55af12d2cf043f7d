// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "nexrad/Grid/GridSpecification.h"

#include <vector>

namespace nexrad
{

/// The levels of a grid as one radar sees them.
struct SiteLevels
{
  /// `altitude` of the antenna, m above mean sea level; `effectiveRadius` of the beams' path, m;
  /// `overlapLength` is L of Formulas W4, m; 0 for equal weights.
  SiteLevels(
    const GridSpecification& grid, double altitude, double effectiveRadius, double overlapLength);

  float radius = 0.0F;       ///< a_e, m
  float bottom = 0.0F;       ///< m above the antenna, of the lowest level
  float perMetre = 0.0F;     ///< levels in a metre
  std::vector<float> ratio;  ///< h/(a_e + h) of each level
  std::vector<float> weight; ///< exp(−(h/L)²) of each level; 1 without a length
};

} // namespace nexrad

// SPDX-License-Identifier: BSD-3-Clause
#include "nexrad/Grid/SiteLevels.h"

#include <cmath>

namespace nexrad
{

SiteLevels::SiteLevels(
  const GridSpecification& grid, double altitude, double effectiveRadius, double overlapLength)
  : radius(static_cast<float>(effectiveRadius))
  , bottom(static_cast<float>(grid.origin[2] - altitude))
  , perMetre(static_cast<float>(1.0 / grid.spacing[2]))
{
  for (int level = 0; level < grid.dimensions[2]; ++level)
  {
    const double height = grid.Coordinate(2, level) - altitude;
    const double part = overlapLength > 0.0 ? height / overlapLength : 0.0;
    ratio.push_back(static_cast<float>(height / (effectiveRadius + height)));
    weight.push_back(static_cast<float>(std::exp(-part * part)));
  }
}

} // namespace nexrad

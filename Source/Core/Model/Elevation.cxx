// SPDX-License-Identifier: BSD-3-Clause
#include "nexrad/Model/Elevation.h"

#include <algorithm>
#include <cmath>

namespace nexrad
{

double MedianOf(std::vector<double> angles)
{
  if (angles.empty())
  {
    return 0.0;
  }
  const auto middle = angles.begin() + static_cast<std::ptrdiff_t>(angles.size() / 2);
  std::nth_element(angles.begin(), middle, angles.end());
  return *middle;
}

bool IsStray(double rayElevation, double cutElevation, double beamWidth)
{
  return std::abs(rayElevation - cutElevation) > 0.5 * beamWidth;
}

} // namespace nexrad

// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <limits>

namespace nexrad
{

/// Reflectivity where there is no echo, dBZ.
constexpr double NoReflectivity = -std::numeric_limits<double>::infinity();

/// Gates of one moment along a ray.
struct GateLayout
{
  int gates = 0;
  int firstGate = 0;   ///< m, centre
  int gateSpacing = 0; ///< m

  double Range(int gate) const { return firstGate + static_cast<double>(gateSpacing) * gate; }
};

} // namespace nexrad

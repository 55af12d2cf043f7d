// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace nexrad
{

/// Gates of one moment along a ray.
struct GateLayout
{
  int gates = 0;
  int firstGate = 0;   ///< m, centre
  int gateSpacing = 0; ///< m

  double Range(int gate) const { return firstGate + static_cast<double>(gateSpacing) * gate; }
};

} // namespace nexrad

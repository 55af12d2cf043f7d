// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "nexrad/Beams/TiltEdges.h"

#include <cstddef>
#include <limits>

namespace nexrad
{

/// Reflectivity over one place on two neighbouring tilts and the tilts beyond them, dBZ, in which
/// no echo is 0 dBZ.
struct TiltGapValues
{
  float below = std::numeric_limits<float>::quiet_NaN(); ///< of the tilt below the two;
                                                         ///< not-a-number where it measured nothing
  float lower = 0.0F;
  float upper = 0.0F;
  float above = std::numeric_limits<float>::quiet_NaN(); ///< of the tilt above the two, likewise
  bool lowerEcho = false;
  bool upperEcho = false;
};

/// Interpolates in elevation (Formulas G11): the four-point cubic, between an echo and none about
/// the line of G8. `edges` are those of the lower tilt; `share`, 0…1, is the part of the way in
/// angle from the lower tilt to the upper one.
class TiltInterpolation
{
public:
  TiltInterpolation(const TiltGapValues& values, const TiltEdges& edges);

  float At(float share) const { return from + share * perShare + curve * share * (1.0F - share); }

private:
  float from;
  float perShare;
  float curve; // four times what the tilts beyond add in the middle
};

} // namespace nexrad

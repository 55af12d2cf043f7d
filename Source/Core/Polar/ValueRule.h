// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "nexrad/Model/RadarVolume.h"

namespace nexrad
{

/// How values of a moment are put together.
struct ValueRule
{
  bool nearest = false;    ///< take the nearest instead of interpolating
  bool linear = false;     ///< values are interpolated as 10^(dBZ/10) (Formulas G5)
  bool zeroIsNone = false; ///< no echo counts as 0 dBZ against an echo (Formulas G8, A1)
  float period = 0.0F;     ///< of angles, in the moment's unit; 0: values are no angles

  /// The rule of a moment: velocity, also that relative to the storm, takes the nearest (as
  /// measured it is folded, and the Nyquist velocity differs from cut to cut; a mean of the two
  /// sides of a vortex is the velocity of neither), differential phase is an angle, the others are
  /// interpolated.
  static ValueRule Of(MomentName moment, bool linearReflectivity);
};

} // namespace nexrad

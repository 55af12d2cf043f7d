// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "nexrad/Polar/PolarVolume.h"

namespace nexrad
{

/// The correlation coefficient from which on a differential phase counts.
constexpr float LeastPhaseCorrelation = 0.9F;

/// The polar volume of KDP: SpecificDifferentialPhase of each ray of PHI (Formulas V6), with the
/// gates of PHI. Reflectivity and correlation of a ray are those of the ray of the same cut,
/// azimuth and time; they may be missing, and then the long windows serve, or all phases count. A
/// phase beside a correlation coefficient below LeastPhaseCorrelation does not count: it is that of
/// noise, of the ground or of insects. Gates with a phase but without K_DP become NotSampled.
PolarVolume MakePhaseSlopes(
  const PolarVolume& phase, const PolarVolume& reflectivity, const PolarVolume& correlation);

} // namespace nexrad

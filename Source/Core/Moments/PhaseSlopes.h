// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "nexrad/Polar/PolarVolume.h"

#include <vector>

namespace nexrad
{

/// Phases that are farther from the straight line through their window than this, root mean square
/// in degrees, are noise and no weather.
constexpr double LargestPhaseSpread = 12.0;

/// The specific differential phase K_DP of one ray, degrees a km, one value a gate (Formulas V6):
/// half the slope of the differential phase, which is smoothed before by a median over 5 gates and
/// a straight line over 9 gates where the reflectivity is above 40 dBZ, over 25 gates elsewhere;
/// the slope is fitted by least squares over as many gates. Turns of 360° along the ray are taken
/// out.
///
/// A stretch of gates ends where five gates or more after each other have no phase. Near an end of
/// a stretch the window does not become shorter, which would let the noise through: it is the last
/// whole one within the stretch. A stretch shorter than the window is fitted as a whole.
///
/// `phase` in degrees and `reflectivity` in dBZ have one value a gate, NaN without one;
/// `gateSpacing` in m, above 0. NaN where fewer than half of the gates of the window have a
/// phase that counts (LargestPhaseSpread). Throws Error when the sizes differ or the spacing is not
/// above 0.
std::vector<float> SpecificDifferentialPhase(
  const std::vector<float>& phase, const std::vector<float>& reflectivity, double gateSpacing);

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

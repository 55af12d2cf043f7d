// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

namespace nexrad
{

/// The median of angles; of an even number the upper one of the two in the middle, so that it is
/// one of them. 0 without any.
double MedianOf(std::vector<double> angles);

/// Elevations that differ by no more are one tilt, degrees. Neighbouring cuts of one pattern lie
/// 0.4° apart or more, repeated ones within 0.1°.
constexpr double SameTilt = 0.15;

/// Whether a ray strays from its cut: its elevation lies farther than half a beam width from that
/// of the cut (Formulas Q7). All in degrees.
bool IsStray(double rayElevation, double cutElevation, double beamWidth);

} // namespace nexrad

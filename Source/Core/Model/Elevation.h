// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
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

/// Whether a cut has an elevation (Formulas Q7): at least half of its rays do not stray from their
/// median. A scan up and down at one azimuth has none.
constexpr bool HasElevation(std::size_t raysOfCut, std::size_t rays)
{
  return 2 * raysOfCut >= rays;
}

} // namespace nexrad

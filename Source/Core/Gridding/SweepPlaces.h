// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace nexrad
{

struct BeamSweep;

/// The entry of a sweep nearest to an azimuth, 0 ≤ azimuth < 360 degrees; −1 where it has no ray
/// there.
int NearestEntry(const BeamSweep& sweep, float azimuth);

/// The largest of the codes of an entry: NoEchoCode where it holds nothing but no echo, below
/// FirstValueCode where it holds no value.
std::uint16_t LargestCode(const BeamSweep& sweep, std::size_t entry);

/// The gate of a sweep that holds a slant range, m; −1 where it has none.
int GateAt(const BeamSweep& sweep, double slantRange);

/// Slant range, m, at which a sweep stands over an arc γ (radians) along the ground, over an earth
/// of `effectiveRadius` m (Formulas G7).
double RangeOver(const BeamSweep& sweep, double arc, double effectiveRadius);

/// For each gate of `other`, the gate of `sweep` over the same place; −1 where it has none. In the
/// standard atmosphere: another refraction changes it by less than a gate.
std::vector<int> GatesOver(const BeamSweep& sweep, const BeamSweep& other);

} // namespace nexrad

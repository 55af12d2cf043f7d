// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "nexrad/Geometry/Beam.h"

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

/// Slant range of the middle of a gate, m.
double RangeOf(const BeamSweep& sweep, int gate);

/// Slant range, m, at which a sweep stands over a ground distance, m.
double RangeOver(const BeamSweep& sweep, double groundDistance, const BeamModel& beam);

/// For each gate of `other`, the gate of `sweep` over the same place; −1 where it has none.
std::vector<int> GatesOver(const BeamSweep& sweep, const BeamSweep& other, const BeamModel& beam);

} // namespace nexrad

// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "nexrad/Geometry/Beam.h"
#include "nexrad/Polar/GateCode.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace nexrad
{

struct BeamSweep;

/// The entry of a sweep nearest to an azimuth, 0 ≤ azimuth < 360 degrees; −1 where it has no ray
/// there.
int NearestEntry(const BeamSweep& sweep, float azimuth);

/// The least and the largest code of a value in a sweep.
struct CodeRange
{
  std::uint16_t least = GateCode::Last;
  std::uint16_t most = 0;

  bool IsEmpty() const { return most < GateCode::FirstValue; }
};
CodeRange FindValueCodes(const BeamSweep& sweep);

/// Slant range of the middle of a gate, m.
double RangeOf(const BeamSweep& sweep, int gate);

/// Slant range, m, at which a sweep stands over a ground distance, m.
double RangeOver(const BeamSweep& sweep, double groundDistance, const BeamModel& beam);

/// For each gate of `other`, the gate of `sweep` over the same place; −1 where it has none.
std::vector<int> GatesOver(const BeamSweep& sweep, const BeamSweep& other, const BeamModel& beam);

} // namespace nexrad

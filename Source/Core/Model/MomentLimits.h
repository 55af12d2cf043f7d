// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "nexrad/Model/RadarVolume.h"

#include <cstddef>
#include <string>
#include <vector>

namespace nexrad
{

/// Of the first `gates` gates of a ray those, ascending, whose words are values that no measurement
/// of the moment can give: a spectrum width below 0; a velocity beyond the ray's Nyquist velocity
/// by more than 1 m/s (when the ray has one), or beside a spectrum width below 0, which is of the
/// same estimate. Empty for other moments. Files have such words (KVWX, 2005-06-26: at edges of
/// echo, words of both moments that were averaged with the word 0 of the gate beside them).
std::vector<std::size_t> ImpossibleGates(
  const Ray& ray, MomentName moment, std::size_t gates = MomentRow::MostGates);

/// One line on all of them in a volume; empty when there are none.
std::string DescribeImpossibleGates(const std::vector<Sweep>& sweeps);

} // namespace nexrad

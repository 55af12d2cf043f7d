// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "nexrad/Level2/Assembly/SweepBuilder.h"
#include "nexrad/Model/VolumeCuts.h"

#include <cstddef>
#include <vector>

namespace nexrad
{

/// What is known of the coverage pattern of the sweeps from `begin` to before `end`: its number,
/// that of most of their rays; its message 5; and how many cuts it has. Of several messages 5 of
/// that number, that whose elevations are those of most sweeps counts, and of two alike the first.
/// Message 5 of another number does not count.
VolumeCuts ChoosePattern(const std::vector<ArrivedSweep>& sweeps, std::size_t begin,
  std::size_t end, const std::vector<CoveragePattern>& patterns);

/// The numbers of the cuts, from 1, at an elevation that the pattern had before a higher cut.
std::vector<int> RepeatedCuts(const CoveragePattern& pattern);

} // namespace nexrad

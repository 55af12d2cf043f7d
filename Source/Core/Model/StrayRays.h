// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "nexrad/Model/RadarVolume.h"

#include <string>
#include <vector>

namespace nexrad
{

/// What the merge leaves out of a volume because the antenna was not at its cut (Formulas Q7), a
/// line for each sweep: its stray rays, or all of it where most of its rays stray. Each line names
/// the sweep, its elevation number, how many rays are left out, and why.
std::vector<std::string> DescribeStrays(const RadarVolume& volume);

/// The same in one line, for a list of many files; empty when nothing is left out.
std::string SummarizeStrays(const RadarVolume& volume);

} // namespace nexrad

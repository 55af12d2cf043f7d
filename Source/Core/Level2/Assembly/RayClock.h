// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "nexrad/Level2/Assembly/ArrivedRay.h"

#include <string>
#include <vector>

namespace nexrad
{

/// Mends times of rays that lie within hours of each other, in the order of the file; no ray comes
/// twice. A time is wrong when the cuts and numbers of the rays go on in the file, and not in the
/// order of the times; a record that came late is the reverse of that, and is left as it is.
///
/// - Up to ten rays between two that follow each other in time get the time of the ray before them.
///   This is reported.
/// - Where the clock goes back, the rays before or those behind it are moved, whichever are fewer:
///   a note, and damage where it goes back by more than LongestStep.
void MendClock(const RayList& rays, const ArrivedDamage& report, std::vector<std::string>& notes);

} // namespace nexrad

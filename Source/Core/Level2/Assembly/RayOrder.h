// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "nexrad/Level2/Assembly/ArrivedRay.h"

#include <optional>
#include <string>
#include <vector>

namespace nexrad
{

/// Puts the rays of one radar, in the order of the file, into the order in which it scanned them. A
/// file that is in order, as all real ones of the test data are, keeps the order that it has.
///
/// - A ray that comes twice (time, cut, azimuth number and azimuth are equal) counts once, that of
///   the two with more gates: a note has their number.
/// - Times that are wrong are mended (RayDates.h), and rays of other hours are left
///   out.
/// - Rays that stand elsewhere in the file go where their time, cut and number say: a note has
///   their number. They stay where cuts and numbers go on better in the file than in time.
/// - An antenna is in one cut at a time. Where the rays of two cuts have the same times, those of
///   the cut with fewer rays are left out, from ten rays to a tenth of the file: damage.
void OrderRays(RayList& rays, std::optional<Time> headerTime, const ArrivedDamage& report,
  std::vector<std::string>& notes);

} // namespace nexrad

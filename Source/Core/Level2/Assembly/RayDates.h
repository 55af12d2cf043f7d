// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "nexrad/Level2/Assembly/ArrivedRay.h"

#include <optional>
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

/// Finds rays of a file whose date is wrong, or that are of another hour or year. The rays have the
/// order of the file; none comes twice. `headerTime` is that of the volume header.
///
/// - A date that does not go on at midnight goes on: a note.
/// - Times that lie within an hour of each other form a group. The group of most rays is right (of
///   two alike the one nearest to the header's time); one within an hour of the header's time goes
///   before it when it has a tenth of the rays. Another group is right when it is a volume of
///   its own: it is before or behind the first one in the file as in time, and within a day of it;
///   and it has thirty rays or more and the start of a volume, or 300 rays.
/// - Other rays that belong between right ones of the file by cut and number are of the file: they
///   get the day of the rays beside them when their time of day fits. Fewer than ten in a row get
///   the time of the ray before them where it does not. This is reported for each.
/// - All others are left out, and reported in one line.
void MendDates(RayList& rays, std::optional<Time> headerTime, const ArrivedDamage& report,
  std::vector<std::string>& notes);

} // namespace nexrad

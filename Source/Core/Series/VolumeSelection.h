// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "nexrad/Model/Time.h"

#include <cstddef>
#include <optional>
#include <vector>

namespace nexrad
{

/// Indices of the volumes of one site just before (or at) a time and just after it, by their
/// nominal times (Formulas T4), as far as they are there. `starts` ascends. A volume farther than
/// `maximumGap` from `time` does not count.
std::vector<std::size_t> FindBracket(
  const std::vector<Time>& starts, Time time, Duration maximumGap);

/// Indices of the volumes of one site that hold the rays just before and just after a time
/// (Formulas A1): the last volume that ended at or before it, those in progress, and the first that
/// starts after it; without those that lie farther than `maximumGap` from the time, whole. Where
/// the motion cannot be estimated from these, one more is added (A3a): the volume before a last
/// one, if it ended no more than `maximumGap` earlier, or the volume after a first one that is
/// alone. Ascending. `starts` and `ends` are of equal length; `starts` ascends.
std::vector<std::size_t> FindVolumesAbout(
  const std::vector<Time>& starts, const std::vector<Time>& ends, Time time, Duration maximumGap);

/// Which volumes of a radar take part at a time.
struct VolumeRule
{
  bool byNominalTimes = false; ///< FindBracket, in place of FindVolumesAbout
  Duration maximumGap{};
};

/// Indices of the volumes that a rule takes, ascending. A volume that started at or before the time
/// and is not taken is not taken at any later time either.
std::vector<std::size_t> ChooseVolumes(const std::vector<Time>& starts,
  const std::vector<Time>& ends, Time time, const VolumeRule& rule);

/// The multiples of `step` since 1970-01-01 from the first at or after `first` to the last at or
/// before `last`. Throws Error when the step is not positive, `last` lies before `first`, or the
/// steps would be more than a million.
std::vector<Time> TimeSteps(Time first, Time last, Duration step);

/// Halfway between two times; to the whole second before it, unless that lies before `first`.
Time MiddleTime(Time first, Time last);

/// From the first to the last ray of a volume, or from one of these to the other.
struct TimeSpan
{
  Time first{};
  Time last{};
};

/// The first pause longer than `longest` between volumes, given in any order: from the last ray
/// before it to the first one after it. Only volumes with rays from `begin` to `end` count.
std::optional<TimeSpan> FindPause(
  std::vector<TimeSpan> volumes, Time begin, Time end, Duration longest);

/// Volumes with a longer pause between them are taken for those of different days: nobody wants the
/// time steps between them.
constexpr Duration LongestPause = std::chrono::hours(24);

} // namespace nexrad

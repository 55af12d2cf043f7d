// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Model/Time.h"

#include <cstddef>
#include <optional>
#include <vector>

namespace nexrad
{

/// Indices of the volumes of one site just before (or at) and just after a time.
struct VolumeBracket
{
  std::optional<std::size_t> before;
  std::optional<std::size_t> after;
};

/// Finds the bracket of `time` among the nominal times of a site's volumes (Formulas T4). `starts`
/// ascends. A volume farther than `maximumGap` from `time` does not count. A volume at `time`
/// exactly is `before`.
VolumeBracket FindBracket(const std::vector<Time>& starts, Time time, Duration maximumGap);

/// Indices of the volumes of one site that hold the rays just before and just after a time
/// (Formulas A1): the last volume that ended at or before it, those in progress, and the first that
/// starts after it; without those that lie farther than `maximumGap` from the time, whole.
/// Ascending. `starts` and `ends` are of equal length; `starts` ascends.
std::vector<std::size_t> FindVolumesAbout(
  const std::vector<Time>& starts, const std::vector<Time>& ends, Time time, Duration maximumGap);

/// The multiples of `step` since 1970-01-01 from the first at or after `first` to the last at or
/// before `last`. Throws Error when the step is not positive, `last` lies before `first`, or the
/// steps would be more than a million.
std::vector<Time> TimeSteps(Time first, Time last, Duration step);

/// The same, for which no step at all is an Error as well.
std::vector<Time> AtLeastOneTimeStep(Time first, Time last, Duration step);

} // namespace nexrad

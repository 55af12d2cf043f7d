// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "nexrad/System/Progress.h"

#include <cstddef>

namespace nexrad
{

/// The progress of a part of the work, which takes the share from `from` to `to` (0…1) of the
/// whole.
inline Progress ShareOf(const Progress& whole, double from, double to)
{
  if (!whole)
  {
    return {};
  }
  return [whole, from, to](double fraction) { return whole(from + (to - from) * fraction); };
}

/// The same for one of `count` equal parts.
inline Progress ShareOf(const Progress& whole, std::size_t part, std::size_t count)
{
  const auto total = static_cast<double>(count);
  return ShareOf(whole, static_cast<double>(part) / total, static_cast<double>(part + 1) / total);
}

/// Share of the whole that finding out what radar files hold takes, before they are merged.
constexpr double scanShare = 0.3;

} // namespace nexrad

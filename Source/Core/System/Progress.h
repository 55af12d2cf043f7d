// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <functional>

namespace nexrad
{

/// Told how much of the work is done (0…1). Returns false to ask that the work stop;
/// the caller of the work then gets no result. An empty function means nobody listens.
using Progress = std::function<bool(double)>;

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

} // namespace nexrad

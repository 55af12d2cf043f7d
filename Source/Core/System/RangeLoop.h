// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>

namespace nexrad
{

/// Runs work over [0, count) in ranges [begin, end), any number of them at a time, and returns when
/// all of it is done.
using RangeLoop =
  std::function<void(int count, const std::function<void(int begin, int end)>& work)>;

/// A loop over `threads` threads of its own, this one included; at least 1.
RangeLoop ThreadLoop(unsigned threads);

/// Runs `work` over [0, count) through a loop, or on this thread when the loop is empty.
void RunLoop(const RangeLoop& loop, int count, const std::function<void(int begin, int end)>& work);

} // namespace nexrad

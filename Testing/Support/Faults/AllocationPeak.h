// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>

namespace nexrad::testing
{

/// Counts the memory that is allocated with `new` while it lives, on all threads: the same in every
/// run, unlike what the system reports. A program that uses it has operators `new` and `delete`
/// that count. One at a time.
class AllocationPeak
{
public:
  AllocationPeak();

  /// The most that was allocated at a time since the beginning, beyond what was there then.
  std::size_t Bytes() const;

private:
  std::size_t start;
};

} // namespace nexrad::testing

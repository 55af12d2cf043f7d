// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <functional>
#include <thread>
#include <vector>

namespace nexrad
{

/// Threads that run one function and end with it. It must not throw.
class ThreadGroup
{
public:
  ThreadGroup() = default;
  /// Starts as Start does.
  ThreadGroup(std::size_t count, const std::function<void()>& run, std::size_t least = 0);
  /// Waits until all of them have ended.
  ~ThreadGroup();
  ThreadGroup(const ThreadGroup&) = delete;
  ThreadGroup& operator=(const ThreadGroup&) = delete;

  /// Starts `count` more, or as many of them as the system gives. Throws Error when these are fewer
  /// than `least`, which may be 1 at most: whoever works with these threads needs none or one.
  void Start(std::size_t count, const std::function<void()>& run, std::size_t least = 0);
  /// Waits until all of them have ended.
  void Join();
  std::size_t Count() const { return threads.size(); }

private:
  std::vector<std::thread> threads;
};

/// Cores of this machine, at least 1.
unsigned CoreCount();

/// Runs work over [0, count) in ranges [begin, end), any number of them at a time, and returns when
/// all of it is done.
using RangeLoop =
  std::function<void(int count, const std::function<void(int begin, int end)>& work)>;

/// A loop over `threads` threads of its own, this one included; at least 1.
RangeLoop ThreadLoop(unsigned threads);

/// Runs `work` over [0, count) through a loop, or on this thread when the loop is empty.
void RunLoop(const RangeLoop& loop, int count, const std::function<void(int begin, int end)>& work);

/// Runs `work` for each number below `count`, as RunLoop does; it may throw. When all is done, what
/// the lowest of the numbers threw is thrown here.
void RunEach(
  const RangeLoop& loop, std::size_t count, const std::function<void(std::size_t number)>& work);

} // namespace nexrad

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
  ThreadGroup(std::size_t count, const std::function<void()>& run);
  /// Waits until all of them have ended.
  ~ThreadGroup();
  ThreadGroup(const ThreadGroup&) = delete;
  ThreadGroup& operator=(const ThreadGroup&) = delete;

  /// Starts `count` more.
  void Start(std::size_t count, const std::function<void()>& run);
  /// Waits until all of them have ended.
  void Join();
  std::size_t Count() const { return threads.size(); }

private:
  std::vector<std::thread> threads;
};

/// Cores of this machine, at least 1.
unsigned CoreCount();

} // namespace nexrad

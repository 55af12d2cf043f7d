// SPDX-License-Identifier: BSD-3-Clause
#include "nexrad/System/ThreadGroup.h"

#include <algorithm>

namespace nexrad
{

ThreadGroup::ThreadGroup(std::size_t count, const std::function<void()>& run)
{
  this->Start(count, run);
}

ThreadGroup::~ThreadGroup()
{
  this->Join();
}

void ThreadGroup::Start(std::size_t count, const std::function<void()>& run)
{
  for (std::size_t i = 0; i < count; ++i)
  {
    threads.emplace_back(run);
  }
}

void ThreadGroup::Join()
{
  for (std::thread& thread : threads)
  {
    thread.join();
  }
  threads.clear();
}

unsigned CoreCount()
{
  return std::max(1U, std::thread::hardware_concurrency());
}

} // namespace nexrad

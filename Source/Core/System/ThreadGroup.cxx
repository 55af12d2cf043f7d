// SPDX-License-Identifier: BSD-3-Clause
#include "nexrad/System/ThreadGroup.h"

#include "nexrad/System/Error.h"

#include <algorithm>
#include <string>
#include <system_error>

namespace nexrad
{

ThreadGroup::ThreadGroup(std::size_t count, const std::function<void()>& run, std::size_t least)
{
  this->Start(count, run, least);
}

ThreadGroup::~ThreadGroup()
{
  this->Join();
}

void ThreadGroup::Start(std::size_t count, const std::function<void()>& run, std::size_t least)
{
  const std::size_t before = threads.size();
  threads.reserve(before + count);
  try
  {
    while (threads.size() < before + count)
    {
      threads.emplace_back(run);
    }
  }
  catch (const std::system_error& problem)
  {
    if (threads.size() < before + least)
    {
      throw Error(std::string("no thread can be started: ") + problem.code().message() +
                  "; raise the limit on processes (ulimit -u) or on memory (ulimit -v)");
    }
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

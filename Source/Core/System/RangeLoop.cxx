// SPDX-License-Identifier: BSD-3-Clause
#include "nexrad/System/RangeLoop.h"

#include "nexrad/System/Error.h"

#include <algorithm>
#include <atomic>
#include <exception>
#include <mutex>
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

RangeLoop ThreadLoop(unsigned threads)
{
  return [threads](int count, const std::function<void(int, int)>& work)
  {
    std::atomic<int> next{0};
    std::exception_ptr thrown;
    std::mutex mutex;
    const auto run = [&]
    {
      try
      {
        for (int each = next++; each < count; each = next++)
        {
          work(each, each + 1);
        }
      }
      catch (...) // what leaves a thread would end the program
      {
        const std::lock_guard<std::mutex> lock(mutex);
        thrown = std::current_exception();
      }
    };
    ThreadGroup others(threads - 1, run);
    run();
    others.Join();
    if (thrown)
    {
      std::rethrow_exception(thrown);
    }
  };
}

void RunLoop(const RangeLoop& loop, int count, const std::function<void(int begin, int end)>& work)
{
  if (loop)
  {
    loop(count, work);
  }
  else
  {
    work(0, count);
  }
}

void RunEach(
  const RangeLoop& loop, std::size_t count, const std::function<void(std::size_t number)>& work)
{
  std::vector<std::exception_ptr> problems(count);
  RunLoop(loop, static_cast<int>(count),
    [&](int begin, int end)
    {
      for (auto i = static_cast<std::size_t>(begin); i < static_cast<std::size_t>(end); ++i)
      {
        try
        {
          work(i);
        }
        catch (...)
        {
          problems[i] = std::current_exception();
        }
      }
    });
  for (const std::exception_ptr& problem : problems)
  {
    if (problem)
    {
      std::rethrow_exception(problem);
    }
  }
}

} // namespace nexrad

// SPDX-License-Identifier: BSD-3-Clause
#include "nexrad/System/RangeLoop.h"

#include "nexrad/System/ThreadGroup.h"

#include <atomic>
#include <exception>
#include <mutex>

namespace nexrad
{

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

} // namespace nexrad

// SPDX-License-Identifier: BSD-3-Clause
#include "nexrad/System/RangeLoop.h"

#include <atomic>
#include <thread>
#include <vector>

namespace nexrad
{

RangeLoop ThreadLoop(unsigned threads)
{
  return [threads](int count, const std::function<void(int, int)>& work)
  {
    std::atomic<int> next{0};
    const auto run = [&next, count, &work]
    {
      for (int each = next++; each < count; each = next++)
      {
        work(each, each + 1);
      }
    };
    std::vector<std::thread> others;
    for (unsigned i = 1; i < threads; ++i)
    {
      others.emplace_back(run);
    }
    run();
    for (std::thread& other : others)
    {
      other.join();
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

// SPDX-License-Identifier: BSD-3-Clause
#include "nexrad/System/RangeLoop.h"

#include "nexrad/System/ThreadGroup.h"

#include <atomic>

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
    const ThreadGroup others(threads - 1, run);
    run();
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

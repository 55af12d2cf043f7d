// SPDX-License-Identifier: BSD-3-Clause
#include "vtkNexradThreads.h"

#include "vtkSMPTools.h"

#include <algorithm>
#include <exception>
#include <mutex>

std::function<void(int, const std::function<void(int, int)>&)> vtkNexradRangeLoop()
{
  return [](int count, const std::function<void(int, int)>& work)
  {
    constexpr vtkIdType grain = 1; // what is done is large, and costs unlike
    // What leaves a thread of VTK would end the program.
    std::exception_ptr thrown;
    std::mutex mutex;
    const auto run = [&](vtkIdType begin, vtkIdType end)
    {
      try
      {
        work(static_cast<int>(begin), static_cast<int>(end));
      }
      catch (...)
      {
        const std::lock_guard<std::mutex> lock(mutex);
        thrown = std::current_exception();
      }
    };
    vtkSMPTools::For(0, count, grain, run);
    if (thrown)
    {
      std::rethrow_exception(thrown);
    }
  };
}

unsigned vtkNexradThreadCount()
{
  return static_cast<unsigned>(std::max(1, vtkSMPTools::GetEstimatedNumberOfThreads()));
}

void vtkNexradSetThreadCount(unsigned count)
{
  vtkSMPTools::Initialize(static_cast<int>(std::max(1U, count)));
}

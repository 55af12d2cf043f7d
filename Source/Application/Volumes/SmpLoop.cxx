// SPDX-License-Identifier: BSD-3-Clause
#include "SmpLoop.h"

#include <vtkSMPTools.h>

#include <algorithm>

namespace nexrad::application
{

RangeLoop SmpLoop()
{
  return [](int count, const std::function<void(int, int)>& work)
  {
    constexpr vtkIdType grain = 1; // what is done is large, and costs unlike
    const auto run = [&work](vtkIdType begin, vtkIdType end)
    { work(static_cast<int>(begin), static_cast<int>(end)); };
    vtkSMPTools::For(0, count, grain, run);
  };
}

unsigned ThreadCount()
{
  return static_cast<unsigned>(std::max(1, vtkSMPTools::GetEstimatedNumberOfThreads()));
}

} // namespace nexrad::application

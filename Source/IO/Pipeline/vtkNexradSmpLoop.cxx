// SPDX-License-Identifier: BSD-3-Clause
#include "vtkNexradSmpLoop.h"

#include "vtkSMPTools.h"

#include <algorithm>

nexrad::RangeLoop vtkNexradSmpLoop()
{
  return [](int count, const std::function<void(int, int)>& work)
  {
    constexpr vtkIdType grain = 1; // the parts of the work are large and of unequal cost
    const auto run = [&work](vtkIdType begin, vtkIdType end)
    { work(static_cast<int>(begin), static_cast<int>(end)); };
    vtkSMPTools::For(0, count, grain, run);
  };
}

unsigned vtkNexradThreadCount()
{
  return static_cast<unsigned>(std::max(1, vtkSMPTools::GetEstimatedNumberOfThreads()));
}

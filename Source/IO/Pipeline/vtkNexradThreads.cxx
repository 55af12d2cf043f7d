// SPDX-License-Identifier: BSD-3-Clause
#include "vtkNexradThreads.h"

#include "vtkSMPTools.h"

#include <algorithm>

std::function<void(int, const std::function<void(int, int)>&)> vtkNexradRangeLoop()
{
  return [](int count, const std::function<void(int, int)>& work)
  {
    constexpr vtkIdType grain = 1; // what is done is large, and costs unlike
    const auto run = [&work](vtkIdType begin, vtkIdType end)
    { work(static_cast<int>(begin), static_cast<int>(end)); };
    vtkSMPTools::For(0, count, grain, run);
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

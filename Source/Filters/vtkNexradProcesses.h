// SPDX-License-Identifier: BSD-3-Clause
/**
 * The processes of a controller as the core sees them.
 */
#ifndef vtkNexradProcesses_h
#define vtkNexradProcesses_h

#include "nexrad/System/Processes.h"
#include "vtkMultiProcessController.h"

#include <cstddef>
#include <string>
#include <vector>

/**
 * What each process of the controller hands over, in the order of their ranks. All of them call it.
 */
inline std::vector<std::string> vtkNexradExchange(
  vtkMultiProcessController* controller, const std::string& mine)
{
  const auto count = static_cast<std::size_t>(controller->GetNumberOfProcesses());
  const auto length = static_cast<vtkIdType>(mine.size());
  std::vector<vtkIdType> lengths(count);
  controller->AllGather(&length, lengths.data(), 1);
  std::vector<vtkIdType> offsets(count, 0);
  for (std::size_t rank = 1; rank < count; ++rank)
  {
    offsets[rank] = offsets[rank - 1] + lengths[rank - 1];
  }
  std::string all(static_cast<std::size_t>(offsets.back() + lengths.back()), '\0');
  controller->AllGatherV(mine.data(), all.data(), length, lengths.data(), offsets.data());
  std::vector<std::string> parts;
  for (std::size_t rank = 0; rank < count; ++rank)
  {
    parts.push_back(
      all.substr(static_cast<std::size_t>(offsets[rank]), static_cast<std::size_t>(lengths[rank])));
  }
  return parts;
}

/**
 * The processes of a controller, which is not owned; without one this process alone.
 */
inline nexrad::Processes vtkNexradProcessesOf(vtkMultiProcessController* controller)
{
  if (!controller)
  {
    return {};
  }
  return {static_cast<std::size_t>(controller->GetLocalProcessId()),
    static_cast<std::size_t>(controller->GetNumberOfProcesses()),
    [controller](const std::string& mine) { return vtkNexradExchange(controller, mine); }};
}

#endif

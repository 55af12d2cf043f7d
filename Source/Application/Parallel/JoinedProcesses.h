// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "nexrad/System/Processes.h"

class vtkMultiProcessController;

namespace nexrad::application
{

/// The processes that mpiexec started together with this one, as long as this lives; one alone
/// without mpiexec, and then MPI is not loaded.
class JoinedProcesses
{
public:
  /// Throws Error when there are several and the program was built without MPI.
  JoinedProcesses();
  ~JoinedProcesses();
  JoinedProcesses(const JoinedProcesses&) = delete;
  JoinedProcesses& operator=(const JoinedProcesses&) = delete;

  Processes Get() const;

private:
  vtkMultiProcessController* controller = nullptr;
};

} // namespace nexrad::application

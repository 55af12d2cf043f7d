// SPDX-License-Identifier: BSD-3-Clause
#include "Parallel/JoinedProcesses.h"

#include "Libraries/ProgramLibrary.h"
#include "Parallel/JoinFunction.h"
#include "Parallel/LaunchedProcess.h"
#include "vtkNexradProcesses.h"

#include <vtkMultiProcessController.h>

namespace nexrad::application
{

JoinedProcesses::JoinedProcesses()
{
  if (FindLaunchedProcess().count > 1)
  {
    const auto join = reinterpret_cast<JoinFunction>(LoadProgramFunction("nexrad3d-mpi.so",
      joinFunctionName, "joins several processes", "nexrad3d-mpi (it needs VTK with MPI)"));
    controller = join();
    if (controller->GetNumberOfProcesses() == 1)
    {
      ForgetLauncher(); // the variables were another program's
    }
  }
}

JoinedProcesses::~JoinedProcesses()
{
  if (controller != nullptr)
  {
    controller->Finalize();
    controller->Delete();
  }
}

Processes JoinedProcesses::Get() const
{
  return vtkNexradProcessesOf(controller);
}

} // namespace nexrad::application

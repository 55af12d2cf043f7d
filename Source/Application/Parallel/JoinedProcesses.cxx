// SPDX-License-Identifier: BSD-3-Clause
#include "Parallel/JoinedProcesses.h"

#include "Libraries/ProgramLibrary.h"
#include "Parallel/LaunchedProcess.h"

#include <vtkMultiProcessController.h>

namespace nexrad::application
{

std::shared_ptr<vtkMultiProcessController> JoinProcesses()
{
  if (FindLaunchedProcess().count == 1)
  {
    return nullptr;
  }
  // The function of nexrad3d-mpi starts MPI and gives a controller of all processes.
  using JoinFunction = vtkMultiProcessController* (*)();
  const auto join = reinterpret_cast<JoinFunction>(LoadProgramFunction(
    {"nexrad3d-mpi.so", "joins several processes", "nexrad3d-mpi (it needs VTK with MPI)"},
    "nexrad3dJoinProcesses"));
  const auto part = [](vtkMultiProcessController* controller)
  {
    controller->Finalize();
    controller->Delete();
  };
  std::shared_ptr<vtkMultiProcessController> joined(join(), part);
  if (joined->GetNumberOfProcesses() == 1)
  {
    ForgetLauncher(); // the variables were another program's
  }
  return joined;
}

} // namespace nexrad::application

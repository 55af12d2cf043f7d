// SPDX-License-Identifier: BSD-3-Clause
#include "Parallel/JoinedProcesses.h"

#include "Libraries/ProgramLibrary.h"
#include "Parallel/LaunchedProcess.h"
#include "vtkNexradProcesses.h"

#include <vtkMultiProcessController.h>

namespace nexrad::application
{
namespace
{

/// The function that the program looks for in nexrad3d-mpi: starts MPI and gives a controller of
/// all processes, which the caller finalizes and deletes.
using JoinFunction = vtkMultiProcessController* (*)();
constexpr char joinFunctionName[] = "nexrad3dJoinProcesses";

} // namespace

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

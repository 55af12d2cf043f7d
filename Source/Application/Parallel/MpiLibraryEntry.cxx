// SPDX-License-Identifier: BSD-3-Clause
#include <vtkMPIController.h>

extern "C" __attribute__((visibility("default"))) vtkMultiProcessController* nexrad3dJoinProcesses()
{
  vtkMPIController* controller = vtkMPIController::New();
  // The command line is read already; MPI may have no arguments.
  int count = 0;
  char** arguments = nullptr;
  controller->Initialize(&count, &arguments);
  return controller;
}

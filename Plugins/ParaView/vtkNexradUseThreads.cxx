// SPDX-License-Identifier: BSD-3-Clause
#include "vtkNexradUseThreads.h"

#include "vtkMultiProcessController.h"
#include "vtkSMPTools.h"

#include <cstdlib>
#include <string>

void vtkNexradUseThreads()
{
  auto* processes = vtkMultiProcessController::GetGlobalController();
  const bool isAlone = !processes || processes->GetNumberOfProcesses() == 1;
  const char* backend = vtkSMPTools::GetBackend();
  if (isAlone && !std::getenv("VTK_SMP_BACKEND_IN_USE") && backend &&
      std::string(backend) == "Sequential")
  {
    vtkSMPTools::SetBackend("STDThread");
  }
}

// SPDX-License-Identifier: BSD-3-Clause
#include "Commands/CommandLine.h"

#ifdef NEXRAD_WITH_VTK
#include "Commands/LoadedCommands.h"
#include "Libraries/VtkErrors.h"
#endif

int main(int argc, char** argv)
{
  using namespace nexrad::application;
#ifdef NEXRAD_WITH_VTK
  TakeVtkErrors();
#endif
  const int status = RunProgram(argc, argv,
    {
      AddInfoCommand,
      AddSimulateCommand,
      AddWindCommand,
#ifdef NEXRAD_WITH_VTK
      AddGridCommand,
      AddRenderCommand,
      AddViewCommand,
      AddWatchCommand,
      AddWebCommand,
      AddDemoCommand,
#endif
    });
#ifdef NEXRAD_WITH_VTK
  return status == Failed || IsFreeOfVtkErrors() ? status : Failed;
#else
  return status;
#endif
}

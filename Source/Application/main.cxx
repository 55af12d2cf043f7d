// SPDX-License-Identifier: BSD-3-Clause
#include "Commands/CommandLine.h"
#include "Commands/InfoCommand.h"
#include "Commands/SimulateCommand.h"
#include "Commands/WindCommand.h"

#ifdef NEXRAD_WITH_VTK
#include "Commands/DemoCommand.h"
#include "Commands/GridCommand.h"
#include "Commands/RenderCommand.h"
#include "Commands/ViewCommand.h"
#include "Libraries/VtkErrors.h"
#include "Live/WatchCommand.h"
#include "Web/WebCommand.h"
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

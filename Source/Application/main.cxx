// SPDX-License-Identifier: BSD-3-Clause
#include "CommandLine.h"
#include "InfoCommand.h"
#include "SimulateCommand.h"

#ifdef NEXRAD_WITH_VTK
#include "BenchCommand.h"
#include "DemoCommand.h"
#include "GridCommand.h"
#include "RenderCommand.h"
#include "ViewCommand.h"
#endif

int main(int argc, char** argv)
{
  using namespace nexrad::application;
  return RunProgram(argc, argv,
    {
      AddInfoCommand,
      AddSimulateCommand,
#ifdef NEXRAD_WITH_VTK
      AddGridCommand,
      AddRenderCommand,
      AddViewCommand,
      AddDemoCommand,
      AddBenchCommand,
#endif
    });
}

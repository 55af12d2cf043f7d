// SPDX-License-Identifier: BSD-3-Clause
#include "Commands/CommandLine.h"
#include "Commands/LoadedCommands.h"

int main(int argc, char** argv)
{
  using namespace nexrad::application;
  return RunProgram(argc, argv,
    {AddInfoCommand, AddSimulateCommand, AddWindCommand, AddGridCommand, AddRenderCommand,
      AddViewCommand, AddWatchCommand, AddWebCommand, AddDemoCommand});
}

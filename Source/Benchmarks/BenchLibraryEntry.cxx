// SPDX-License-Identifier: BSD-3-Clause
#include "BenchCommandLine.h"

/// The function that the program looks for in this library (Source/Application/BenchCommand.h).
extern "C" __attribute__((visibility("default"))) void nexrad3dAddBench(
  CLI::App* command, nexrad::application::CommandAction* action)
{
  nexrad::application::AddBenchOptions(*command, *action);
}

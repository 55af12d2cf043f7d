// SPDX-License-Identifier: BSD-3-Clause
#include "Commands/LoadedCommands.h"

/// The function that the program looks for in this library.
extern "C" __attribute__((visibility("default"))) void nexrad3dAddOptions(
  const char*, CLI::App* command, nexrad::application::CommandAction* action)
{
  nexrad::application::AddViewOptions(*command, *action);
}

// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Commands/CommandLine.h"

namespace nexrad::application
{

/// Commands whose options and work are in a library, which is loaded when one of them is called.
/// The program itself starts without VTK.
void AddDemoCommand(CLI::App& program, CommandAction& action);
void AddGridCommand(CLI::App& program, CommandAction& action);
void AddRenderCommand(CLI::App& program, CommandAction& action);
void AddViewCommand(CLI::App& program, CommandAction& action);
void AddWatchCommand(CLI::App& program, CommandAction& action);
void AddWebCommand(CLI::App& program, CommandAction& action);

/// The function of a command in such a library, by which the program calls it: it adds the options
/// to the command, whose callback then sets the action.
using AddOptionsFunction = void (*)(CLI::App& command, CommandAction& action);
#define NEXRAD_ADD_OPTIONS(command)                                                                \
  extern "C" __attribute__((visibility("default"))) void nexrad3dAddOptions_##command

} // namespace nexrad::application

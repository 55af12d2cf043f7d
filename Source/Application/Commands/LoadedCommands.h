// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Commands/Command.h"

namespace nexrad::application
{

/// Commands whose options and work are in a library, which is loaded when one of them is called.
void AddDemoCommand(CLI::App& program, CommandAction& action);
void AddRenderCommand(CLI::App& program, CommandAction& action);
void AddViewCommand(CLI::App& program, CommandAction& action);
void AddWebCommand(CLI::App& program, CommandAction& action);

/// The function by which the program calls such a library: it adds the options to the command of
/// that name, whose callback then sets the action.
using AddOptionsFunction = void (*)(const char* name, CLI::App* command, CommandAction* action);
constexpr char addOptionsFunctionName[] = "nexrad3dAddOptions";

} // namespace nexrad::application

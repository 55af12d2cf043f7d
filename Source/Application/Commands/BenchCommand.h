// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Commands/Command.h"

namespace nexrad::application
{

/// `nexrad3d bench`. Its options and its work are in a library, which is loaded when the command is
/// called.
void AddBenchCommand(CLI::App& program, CommandAction& action);

/// The function by which the program calls the library: it adds the options to the command, whose
/// callback then sets the action.
using BenchFunction = void (*)(CLI::App* command, CommandAction* action);
constexpr char benchFunctionName[] = "nexrad3dAddBench";

} // namespace nexrad::application

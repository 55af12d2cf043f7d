// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Commands/Command.h"

#include <vector>

namespace nexrad::application
{

/// Adds one command to the program's command line.
using AddCommand = void (*)(CLI::App& program, CommandAction& action);

/// Parses the command line, runs the chosen command and returns the exit status. Every failure is
/// one line on standard error that starts with the program's name and the command; wrong usage also
/// names the option.
int RunProgram(int argc, const char* const* argv, const std::vector<AddCommand>& commands);

} // namespace nexrad::application

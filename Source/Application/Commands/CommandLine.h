// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <vector>

namespace CLI
{
class App;
}

/// The program nexrad3d. Each command adds itself to the command line; main.cxx lists them.
namespace nexrad::application
{

/// What the program returns to the shell.
enum ExitStatus
{
  Done = 0,          ///< all inputs were used, all outputs made
  Failed = 1,        ///< no ray in any input, or no output made
  WrongUsage = 2,    ///< the command line asks for something that does not exist
  DoneWithDamage = 3 ///< done, but some input was damaged or left out
};

/// The work of the chosen command, set by the command's callback while the command line is parsed
/// and run after it. Returns an ExitStatus. A nexrad::Error that leaves it is printed as one line
/// and becomes Failed.
using CommandAction = std::function<int()>;

/// What is in Level II files and folders of chunks, as a table or as JSON. Damage goes to standard
/// error, one line each: "file: offset N: what".
void AddInfoCommand(CLI::App& program, CommandAction& action);

/// The synthetic storm day as Level II files.
void AddSimulateCommand(CLI::App& program, CommandAction& action);

/// The wind profile of each volume, as a table or JSON.
void AddWindCommand(CLI::App& program, CommandAction& action);

/// Adds one command to the program's command line.
using AddCommand = void (*)(CLI::App& program, CommandAction& action);

/// Parses the command line, runs the chosen command and returns the exit status. Every failure is
/// one line on standard error that starts with the program's name and the command; wrong usage also
/// names the option.
int RunProgram(int argc, const char* const* argv, const std::vector<AddCommand>& commands);

} // namespace nexrad::application

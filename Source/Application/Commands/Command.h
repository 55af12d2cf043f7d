// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>

namespace CLI
{
class App;
}

/// The program nexrad3d. Each command adds itself to the command line in a function
/// `Add<Name>Command(CLI::App&, CommandAction&)` declared in `<Name>Command.h`, and main.cxx lists
/// these functions.
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

} // namespace nexrad::application

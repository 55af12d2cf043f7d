// SPDX-License-Identifier: BSD-3-Clause
#include "Commands/LoadedCommands.h"

#include <string>

/// The function that the program looks for in this library.
extern "C" __attribute__((visibility("default"))) void nexrad3dAddOptions(
  const char* name, CLI::App* command, nexrad::application::CommandAction* action)
{
  using namespace nexrad::application;
  const auto add = std::string("demo") == name  ? AddDemoOptions
                   : std::string("web") == name ? AddWebOptions
                                                : AddRenderOptions;
  add(*command, *action);
}

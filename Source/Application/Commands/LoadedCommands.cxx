// SPDX-License-Identifier: BSD-3-Clause
#include "Commands/LoadedCommands.h"

#include "Libraries/ProgramLibrary.h"
#include "nexrad/System/Error.h"

#include <CLI/CLI.hpp>

#include <string>

namespace nexrad::application
{
namespace
{

const ProgramLibrary sceneLibrary = {
  "nexrad3d-scene.so", "draws", "nexrad3d-scene, which needs VTK"};
const ProgramLibrary volumesLibrary = {
  "nexrad3d-volumes.so", "merges", "nexrad3d-volumes, which needs VTK"};
const ProgramLibrary windowLibrary = {"nexrad3d-window.so", "has the window of view",
  "nexrad3d-window, which needs Qt 5 and VTK's module GUISupportQt"};

void AddLoadedCommand(CLI::App& program, CommandAction& action, const ProgramLibrary& library,
  const char* name, const char* description)
{
  CLI::App* command = program.add_subcommand(name, description);
  const auto load = [command, name, &library, &action](std::size_t)
  {
    try
    {
      const auto add = reinterpret_cast<AddOptionsFunction>(
        LoadProgramFunction(library, std::string("nexrad3dAddOptions_") + name));
      add(*command, action);
    }
    catch (const Error& error)
    {
      // Without the library no option is known; what is wrong is said when the command runs.
      command->allow_extras();
      action = [error]() -> int { throw error; };
    }
  };
  command->preparse_callback(load);
}

} // namespace

void AddDemoCommand(CLI::App& program, CommandAction& action)
{
  AddLoadedCommand(program, action, sceneLibrary, "demo",
    "Simulate storms over Missouri and Illinois as three radars scan them from 18:00 UTC on, merge "
    "the files, and draw pictures and a movie; all are marked SYNTHETIC");
}

void AddGridCommand(CLI::App& program, CommandAction& action)
{
  AddLoadedCommand(program, action, volumesLibrary, "grid",
    "Merge radar files of any number of sites into one volume for each time step");
}

void AddRenderCommand(CLI::App& program, CommandAction& action)
{
  AddLoadedCommand(program, action, sceneLibrary, "render",
    "Draw volumes, or radar files, as pictures or a movie");
}

void AddViewCommand(CLI::App& program, CommandAction& action)
{
  AddLoadedCommand(program, action, windowLibrary, "view",
    "Show volumes, radar files, or a session that was saved (.nxsession), in a window");
}

void AddWatchCommand(CLI::App& program, CommandAction& action)
{
  AddLoadedCommand(program, action, volumesLibrary, "watch",
    "Follow folders into which volumes or real-time chunks of any number of sites arrive; keep the "
    "newest merged volume, its picture and a series of volumes current");
}

void AddWebCommand(CLI::App& program, CommandAction& action)
{
  AddLoadedCommand(program, action, sceneLibrary, "web",
    "Make a page that turns and plays volumes, or radar files, in a browser");
}

} // namespace nexrad::application

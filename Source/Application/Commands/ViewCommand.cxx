// SPDX-License-Identifier: BSD-3-Clause
#include "Commands/ViewCommand.h"

#include "Libraries/SceneLibrary.h"
#include "Options/DrawingOptions.h"
#include "Options/GridOptions.h"
#include "Options/ThreadOptions.h"
#include "Options/UnitOptions.h"
#include "Output/MessageOutput.h"
#include "Output/ProgressBar.h"

#include <CLI/CLI.hpp>

#include <iostream>
#include <memory>

namespace nexrad::application
{
namespace
{

struct ViewOptions
{
  scene::ViewRequest request;
  bool quiet = false;
};

int RunView(const ViewOptions& options)
{
  const scene::ViewReport report = WindowWithLibrary(options.request);
  if (!options.quiet)
  {
    for (const auto& path : report.pictures)
    {
      std::cout << path.string() << '\n';
    }
  }
  for (const std::string& note : report.notes)
  {
    PrintMessage(note);
  }
  for (const std::string& problem : report.problems)
  {
    PrintMessage(problem);
  }
  return report.problems.empty() ? Done : DoneWithDamage;
}

} // namespace

void AddViewCommand(CLI::App& program, CommandAction& action)
{
  const auto options = std::make_shared<ViewOptions>();
  scene::ViewRequest& request = options->request;
  CLI::App* command = program.add_subcommand(
    "view", "Show volumes, radar files, or a session that was saved (.nxsession), in a window");
  AddInputOptions(*command, request.input, false);
  AddQuietOption(*command, options->quiet);
  AddDrawingOptions(*command, request);
  AddParsedOption(*command, "--interval", request.interval, ParseInterval, "DURATION",
    "Time from one step to the next in playing", "0.5s");
  command
    ->add_option("--pictures", request.pictures, "Folder that takes the pictures that key s writes")
    ->check(CLI::Validator(CLI::ExistingDirectory).description(""))
    ->type_name("DIR")
    ->capture_default_str();
  AddGridOptions(*command, request.input.grid);
  AddThreadsOption(*command);
  const auto run = [options, command, &action]
  {
    FinishDrawingOptions(*command, options->request);
    action = [options] { return RunView(*options); };
  };
  command->callback(run);
}

} // namespace nexrad::application

// SPDX-License-Identifier: BSD-3-Clause
#include "Commands/ViewCommand.h"

#include "Libraries/SceneLibrary.h"
#include "Options/DrawingOptions.h"
#include "Options/GridOptions.h"
#include "Options/SessionFile.h"
#include "Options/ThreadOptions.h"
#include "Options/UnitOptions.h"
#include "Output/MessageOutput.h"
#include "Output/ProgressBar.h"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <iostream>
#include <memory>

namespace nexrad::application
{
namespace
{

struct ViewOptions
{
  scene::ViewRequest request;
  bool plain = false;
  bool quiet = false;
};

// What is read before a plain window opens shows its progress in the terminal; the other window
// shows its own.
scene::ViewReport Show(ViewOptions& options)
{
  if (!options.plain)
  {
    return WindowWithLibrary(options.request);
  }
  ProgressBar bar("opening", options.quiet);
  options.request.progress = [&bar](double fraction)
  {
    const bool goOn = bar.Update(fraction);
    if (fraction >= 1.0)
    {
      bar.Clear();
    }
    return goOn;
  };
  return ViewWithLibrary(options.request);
}

void RequireInputsOfPlainWindow(const std::vector<std::filesystem::path>& inputs)
{
  if (inputs.empty())
  {
    throw CLI::RequiredError("input");
  }
  if (std::any_of(inputs.begin(), inputs.end(), IsSessionFile))
  {
    throw CLI::ValidationError("input", "the plain window opens no sessions");
  }
}

int RunView(ViewOptions& options)
{
  const scene::ViewReport report = Show(options);
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
  command->add_flag("--plain", options->plain,
    "A window without menus and panels, which lists its keys; the only one where the program was "
    "built without Qt");
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
    options->plain = options->plain || !HasWindowLibrary();
    if (options->plain)
    {
      RequireInputsOfPlainWindow(options->request.input.inputs);
    }
    FinishDrawingOptions(*command, options->request);
    action = [options] { return RunView(*options); };
  };
  command->callback(run);
}

} // namespace nexrad::application

// SPDX-License-Identifier: BSD-3-Clause
#include "Commands/Command.h"

#include "Options/DrawingOptions.h"
#include "Options/GridOptions.h"
#include "Options/ThreadOptions.h"
#include "Options/UnitOptions.h"
#include "Output/MessageOutput.h"
#include "Output/ProgressBar.h"
#include "Viewer/RunWindow.h"

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
  const scene::ViewReport report = viewer::RunWindow(options.request);
  if (!options.quiet)
  {
    for (const auto& path : report.pictures)
    {
      std::cout << path.string() << '\n';
    }
  }
  PrintMessages(report.notes);
  PrintMessages(report.problems);
  return report.problems.empty() ? Done : DoneWithDamage;
}

} // namespace

void AddViewOptions(CLI::App& command, CommandAction& action)
{
  const auto options = std::make_shared<ViewOptions>();
  scene::ViewRequest& request = options->request;
  AddInputOptions(command, request.input, false);
  AddQuietOption(command, options->quiet);
  AddDrawingOptions(command, request);
  AddParsedOption(command, "--interval", request.interval, ParseInterval, "DURATION",
    "Time from one step to the next in playing", "0.5s");
  command
    .add_option("--pictures", request.pictures, "Folder that takes the pictures that key s writes")
    ->check(CLI::Validator(CLI::ExistingDirectory).description(""))
    ->type_name("DIR")
    ->capture_default_str();
  AddGridOptions(command, request.input.grid);
  AddThreadsOption(command);
  const auto run = [options, &command, &action]
  {
    FinishDrawingOptions(command, options->request);
    action = [options] { return RunView(*options); };
  };
  command.callback(run);
}

} // namespace nexrad::application

// SPDX-License-Identifier: BSD-3-Clause
#include "Commands/LoadedCommands.h"
#include "Libraries/VtkErrors.h"
#include "Options/DrawingOptions.h"
#include "Options/UnitOptions.h"
#include "Output/MessageOutput.h"
#include "Output/ProgressBar.h"
#include "Web/WebPage.h"

#include <CLI/CLI.hpp>

#include <memory>

namespace nexrad::application
{
namespace
{

struct WebOptions
{
  scene::WebRequest request;
  bool quiet = false;
};

std::filesystem::path ParsePage(const std::string& text)
{
  const std::filesystem::path path(text);
  const std::string extension = path.extension().string();
  const bool folder = extension.empty() || std::filesystem::is_directory(path);
  if (text.empty() || (!folder && extension != ".html" && extension != ".htm"))
  {
    throw Error("'" + text +
                "' is no page; write a name that ends in .html, or a folder for a page beside "
                "volume files");
  }
  return path;
}

int RunWeb(WebOptions& options)
{
  ProgressBar bar("making the page", options.quiet);
  options.request.progress = [&bar](double fraction) { return bar.Update(fraction); };
  const Outcome outcome = MakeWebPage(options.request);
  bar.Clear();
  PrintOutcome(outcome, options.quiet);
  return outcome.problems.empty() ? Done : DoneWithDamage;
}

} // namespace

NEXRAD_ADD_OPTIONS(web)(CLI::App& command, CommandAction& action)
{
  const auto options = std::make_shared<WebOptions>();
  scene::WebRequest& request = options->request;
  AddTimedInputs(command, request.input);
  AddParsedOption(command, "-o,--output", request.output, ParsePage, "PAGE",
    "One file (.html) that opens without a server or a network; or a folder, for a page that reads "
    "volume files beside it from a server, and follows a series that grows")
    ->required();
  AddQuietOption(command, options->quiet);
  AddPageOptions(command, request);
  AddGridOptions(command, request.input.grid);
  const auto run = [options, &command, &action]
  {
    options->request.input.momentNamed = command.count("--moment") > 0;
    action = [options] { return FailOnVtkErrors([&] { return RunWeb(*options); }); };
  };
  command.callback(run);
}

} // namespace nexrad::application

// SPDX-License-Identifier: BSD-3-Clause
#include "Commands/LoadedCommands.h"
#include "Drawing/PictureWindow.h"
#include "Libraries/VtkErrors.h"
#include "Options/DrawingOptions.h"
#include "Options/ThreadOptions.h"
#include "Options/UnitOptions.h"
#include "Output/MessageOutput.h"
#include "Output/ProgressBar.h"
#include "Scene/VolumeAppearance.h"
#include "Viewer/MainWindow.h"

#include <CLI/CLI.hpp>

#include <QApplication>
#include <QSurfaceFormat>
#include <QVTKOpenGLNativeWidget.h>

#include <clocale>
#include <filesystem>
#include <memory>

namespace nexrad::application
{
namespace
{

struct ViewOptions
{
  viewer::ViewRequest request;
  bool quiet = false;
};

// Shows the window until the user closes it.
Outcome RunWindow(const viewer::ViewRequest& request)
{
  scene::RequireDisplay();
  QSurfaceFormat::setDefaultFormat(QVTKOpenGLNativeWidget::defaultFormat());
  QCoreApplication::setAttribute(Qt::AA_EnableHighDpiScaling);
  QCoreApplication::setOrganizationName("nexrad3d");
  QCoreApplication::setApplicationName("nexrad3d");
  int count = 1;
  char name[] = "nexrad3d";
  char* arguments[] = {name, nullptr};
  QApplication application(count, arguments);
  // Qt takes the user's locale, in which numbers in files may have a comma.
  std::setlocale(LC_NUMERIC, "C");
  viewer::MainWindow window(request);
  window.show();
  QApplication::exec();
  Outcome outcome;
  for (const std::filesystem::path& picture : window.Pictures())
  {
    outcome.made.push_back(picture.string());
  }
  outcome.notes = scene::LinesPassedOver(request.scene);
  for (const QString& line : window.Problems())
  {
    outcome.problems.push_back(line.toStdString());
  }
  return outcome;
}

int RunView(const ViewOptions& options)
{
  const Outcome outcome = RunWindow(options.request);
  PrintOutcome(outcome, options.quiet);
  return outcome.problems.empty() ? Done : DoneWithDamage;
}

} // namespace

NEXRAD_ADD_OPTIONS(view)(CLI::App& command, CommandAction& action)
{
  const auto options = std::make_shared<ViewOptions>();
  viewer::ViewRequest& request = options->request;
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
    action = [options] { return FailOnVtkErrors([&] { return RunView(*options); }); };
  };
  command.callback(run);
}

} // namespace nexrad::application

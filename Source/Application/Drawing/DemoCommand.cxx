// SPDX-License-Identifier: BSD-3-Clause
#include "Commands/LoadedCommands.h"
#include "Commands/SimulatedFiles.h"
#include "Drawing/Render.h"
#include "Libraries/VtkErrors.h"
#include "Options/UnitOptions.h"
#include "Output/OutputFile.h"
#include "Output/ProgressBar.h"
#include "Volumes/WriteVolumes.h"
#include "nexrad/System/Error.h"

#include <CLI/CLI.hpp>

#include <chrono>
#include <cstdlib>
#include <iomanip>
#include <iostream>
#include <memory>

namespace fs = std::filesystem;

namespace nexrad::application
{
namespace
{

struct DemoOptions
{
  fs::path folder;
  Duration length = std::chrono::hours(1);
  std::array<int, 3> dimensions = {256, 256, 128};
  std::array<int, 2> size = {1280, 720};
  bool quiet = false;
};

// Says what one stage made, in one line of the summary.
class Stage
{
public:
  Stage(const std::string& what, bool quietRun)
    : bar(what, quietRun)
    , quiet(quietRun)
  {
  }

  Progress GetProgress()
  {
    return [this](double fraction) { return bar.Update(fraction); };
  }

  void Finish(
    std::size_t count, const std::string& things, std::uintmax_t bytes, const fs::path& where)
  {
    bar.Clear();
    const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - start;
    if (!quiet)
    {
      std::cout << std::setw(4) << count << ' ' << std::left << std::setw(18) << things
                << std::right << std::fixed << std::setprecision(1) << std::setw(8)
                << static_cast<double>(bytes) / 1e6 << " MB" << std::setw(8) << seconds.count()
                << " s   " << where.string() << std::endl;
    }
  }

private:
  ProgressBar bar;
  bool quiet;
  std::chrono::steady_clock::time_point start = std::chrono::steady_clock::now();
};

// Before a minute of work that would be for nothing. Whether the display can be used is found out
// when it is.
void RequireDisplayVariable()
{
  const char* display = std::getenv("DISPLAY");
  if (display == nullptr || *display == '\0')
  {
    throw Error("no X display to draw on (DISPLAY is not set); without a screen, run under "
                "xvfb-run -a");
  }
}

std::vector<fs::path> SimulateStage(const DemoOptions& options)
{
  Stage stage("simulating", options.quiet);
  const fs::path folder = options.folder / "level2";
  const SimulationReport report =
    WriteSimulatedFiles(DemoDay(options.length), folder, stage.GetProgress());
  stage.Finish(report.files.size(), "Level II files", report.bytes, folder);
  return report.files;
}

GridReport GridStage(const DemoOptions& options, const std::vector<fs::path>& files)
{
  Stage stage("merging", options.quiet);
  GridJob job;
  job.inputs = files; // not the folder, which may hold those of another run
  job.folder = options.folder / "volumes";
  job.options.grid.dimensions = options.dimensions;
  const GridReport report = WriteVolumes(job, stage.GetProgress());
  stage.Finish(report.files.size(), "merged volumes", report.bytes, report.indices.front());
  return report;
}

void DrawStage(const DemoOptions& options, scene::RenderRequest request, const std::string& things)
{
  Stage stage("drawing", options.quiet);
  request.progress = stage.GetProgress();
  const Outcome outcome = scene::Render(request);
  stage.Finish(outcome.made.size(), things, fs::file_size(request.output), request.output);
}

void DrawStages(const DemoOptions& options, const GridReport& volumes)
{
  scene::RenderRequest picture;
  picture.input.inputs = {volumes.files[volumes.files.size() / 2]};
  picture.size = options.size;
  picture.output = options.folder / "storms.png";
  DrawStage(options, picture, "picture");

  scene::RenderRequest above = picture;
  above.output = options.folder / "storms-from-above.png";
  above.camera.azimuth = 180.0;
  above.camera.tilt = 90.0;
  above.camera.parallel = true;
  above.scene.ringSpacing = 100'000.0;
  DrawStage(options, above, "picture");

  scene::RenderRequest movie;
  movie.input.inputs = {volumes.indices.front()};
  movie.size = {options.size[0] * 3 / 4, options.size[1] * 3 / 4};
  movie.output = options.folder / "storms.ogv";
  movie.frames = static_cast<int>(4 * volumes.files.size());
  movie.turn = 60.0;
  movie.camera.azimuth = 170.0;
  DrawStage(options, movie, "movie");
}

int RunDemo(const DemoOptions& options)
{
  const auto start = std::chrono::steady_clock::now();
  RequireDisplayVariable();
  WatchStopSignals();
  MakeFolder(options.folder);
  const std::vector<fs::path> files = SimulateStage(options);
  DrawStages(options, GridStage(options, files));
  const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - start;
  if (!options.quiet)
  {
    std::cout << "All data are SYNTHETIC. " << std::fixed << std::setprecision(1) << seconds.count()
              << " s in all.\n";
  }
  return Done;
}

Duration ParseLengthOfDemo(const std::string& text)
{
  const Duration length = ParseDuration(text);
  if (length < std::chrono::minutes(5) || length > std::chrono::hours(24))
  {
    throw Error("'" + text + "' is no length of the demo; write 5min to 24h");
  }
  return length;
}

} // namespace

NEXRAD_ADD_OPTIONS(demo)(CLI::App& command, CommandAction& action)
{
  const auto options = std::make_shared<DemoOptions>();
  command.add_option("folder", options->folder, "Folder that takes everything; made when missing")
    ->required()
    ->type_name("DIR");
  AddParsedOption(command, "--length", options->length, ParseLengthOfDemo, "DURATION",
    "Time simulated, in min or h", "1h");
  AddParsedOption(command, "--dims", options->dimensions, ParseDimensions, "XxYxZ",
    "Voxels to the east, to the north and upward", "256x256x128");
  AddParsedOption(command, "--size", options->size, ParsePictureSize, "WxH",
    "Width and height of the pictures in pixels; the movie has three quarters", "1280x720");
  AddQuietOption(command, options->quiet);
  command.callback([options, &action]
    { action = [options] { return FailOnVtkErrors([&] { return RunDemo(*options); }); }; });
}

} // namespace nexrad::application

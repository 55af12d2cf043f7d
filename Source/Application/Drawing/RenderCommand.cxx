// SPDX-License-Identifier: BSD-3-Clause
#include "Commands/LoadedCommands.h"
#include "Drawing/Render.h"
#include "Libraries/VtkErrors.h"
#include "Options/DrawingOptions.h"
#include "Options/ThreadOptions.h"
#include "Options/UnitOptions.h"
#include "Output/MessageOutput.h"
#include "Output/ProgressBar.h"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <array>
#include <memory>

namespace nexrad::application
{
namespace
{

struct RenderOptions
{
  scene::RenderRequest request;
  bool quiet = false;
};

std::filesystem::path ParseOutput(const std::string& text)
{
  const std::filesystem::path path(text);
  const std::string extension = path.extension().string();
  constexpr std::array<const char*, 5> known = {".png", ".ogv", ".mp4", ".tif", ".glb"};
  if (std::find(known.begin(), known.end(), extension) == known.end())
  {
    throw Error("'" + text +
                "' is no picture, movie, map or model; write a name that ends in .png, .ogv, .mp4, "
                ".tif or .glb");
  }
  return path;
}

void AddMovie(CLI::App& command, scene::RenderRequest& request)
{
  constexpr char group[] = "Movie";
  AddValueOption(command, "--fps", request.framesPerSecond, NumberValue(1, 120), "Frames a second")
    ->group(group);
  AddValueOption(command, "--frames", request.frames, NumberValue(0, 100'000),
    "Number of frames; 0: one for each time")
    ->group(group);
  AddValueOption(command, "--turn", request.turn, RealValue(-36'000.0, 36'000.0, "DEGREES"),
    "How far the camera goes round during the movie")
    ->group(group);
  command
    .add_flag("--fly", request.fly,
      "The camera flies from the whole frame to --zoom and --look-at during the movie")
    ->group(group);
}

// Throws for what a file of that kind cannot show.
void CheckOutput(const scene::RenderRequest& request)
{
  const std::string extension = request.output.extension().string();
  if (extension == ".tif" && !request.scene.plan)
  {
    throw CLI::ValidationError("--output", "a .tif is a map; write --map composite as well");
  }
  if (extension == ".glb" && request.scene.plan)
  {
    throw CLI::ValidationError("--output", "a .glb has surfaces; a map is a .png or a .tif");
  }
  if (request.fly && !request.camera.lookAt && request.camera.zoom == 1.0)
  {
    throw CLI::ValidationError("--fly", "needs a place to fly to; write --look-at or --zoom");
  }
  if (extension == ".glb" && !request.scene.colourBy.empty())
  {
    throw CLI::ValidationError("--colour-by", "is of pictures; a surface of a .glb has one colour");
  }
}

int RunRender(RenderOptions& options)
{
  WatchStopSignals();
  ProgressBar bar("drawing", options.quiet);
  options.request.progress = [&bar](double fraction) { return bar.Update(fraction); };
  const Outcome outcome = scene::Render(options.request);
  bar.Clear();
  PrintOutcome(outcome, options.quiet);
  return outcome.problems.empty() ? Done : DoneWithDamage;
}

} // namespace

NEXRAD_ADD_OPTIONS(render)(CLI::App& command, CommandAction& action)
{
  const auto options = std::make_shared<RenderOptions>();
  scene::RenderRequest& request = options->request;
  AddInputOptions(command, request.input);
  AddParsedOption(command, "-o,--output", request.output, ParseOutput, "FILE",
    "Picture (.png; one for each time, with the time in its name, when there are several, and one "
    "of all radars where each has one file) or movie "
    "(.ogv, or .mp4 where ffmpeg is installed); the surfaces of --iso-values as glTF (.glb); with "
    "--map also a GeoTIFF of its numbers (.tif)")
    ->required();
  AddQuietOption(command, options->quiet);
  AddDrawingOptions(command, request);
  AddMovie(command, request);
  AddGridOptions(command, request.input.grid);
  AddThreadsOption(command);
  const auto run = [options, &command, &action]
  {
    FinishDrawingOptions(command, options->request);
    CheckOutput(options->request);
    action = [options] { return FailOnVtkErrors([&] { return RunRender(*options); }); };
  };
  command.callback(run);
}

} // namespace nexrad::application

// SPDX-License-Identifier: BSD-3-Clause
#include "Commands/RenderCommand.h"

#include "Libraries/SceneLibrary.h"
#include "Options/DrawingOptions.h"
#include "Options/GridOptions.h"
#include "Options/UnitOptions.h"
#include "Output/ProgressBar.h"

#include <CLI/CLI.hpp>

#include <cmath>
#include <iostream>
#include <locale>
#include <memory>
#include <sstream>

namespace nexrad::application
{
namespace
{

struct RenderOptions
{
  scene::RenderRequest request;
  std::string array;
  bool quiet = false;
};

std::filesystem::path ParseOutput(const std::string& text)
{
  const std::filesystem::path path(text);
  const std::string extension = path.extension().string();
  if (extension != ".png" && extension != ".ogv" && extension != ".mp4")
  {
    throw Error(
      "'" + text + "' is no picture or movie; write a name that ends in .png, .ogv or .mp4");
  }
  return path;
}

// What follows "echo-top": nothing, or a colon and dBZ.
double ParseThreshold(const std::string& text, const std::string& end, double usual)
{
  std::istringstream stream(end);
  stream.imbue(std::locale::classic());
  char colon = ':';
  double threshold = usual;
  if (!end.empty())
  {
    stream >> colon >> threshold;
  }
  if (stream.fail() || colon != ':' || stream.peek() != std::istringstream::traits_type::eof() ||
      !(std::abs(threshold) <= 100.0))
  {
    throw Error("'" + text + "' is no echo top; write echo-top, or echo-top:30 for that of 30 dBZ");
  }
  return threshold;
}

scene::PlanOptions ParsePlan(const std::string& text)
{
  scene::PlanOptions plan;
  if (text == "composite" || text == "lowest")
  {
    plan.level = text == "lowest" ? scene::PlanLevel::Lowest : scene::PlanLevel::Composite;
    return plan;
  }
  if (text == "vil")
  {
    plan.level = scene::PlanLevel::Liquid;
    return plan;
  }
  if (const std::string echoTop = "echo-top"; text.compare(0, echoTop.size(), echoTop) == 0)
  {
    plan.level = scene::PlanLevel::EchoTop;
    plan.threshold = ParseThreshold(text, text.substr(echoTop.size()), plan.threshold);
    return plan;
  }
  try
  {
    plan.level = scene::PlanLevel::Height;
    plan.height = ParseLength(text);
  }
  catch (const Error&)
  {
    throw Error(
      "'" + text + "' is no map; write composite, lowest, echo-top, vil, or a height as in 3km");
  }
  return plan;
}

void AddMap(CLI::App& command, RenderOptions& options)
{
  constexpr char group[] = "Map in place of the volume";
  AddParsedOption(command, "--map", options.request.scene.plan, ParsePlan, "WHICH",
    "Of each column the largest value (composite; of VEL the fastest), the lowest that was scanned "
    "(lowest), the one at a height above mean sea level, m or km, the height of the echo top at 18 "
    "dBZ or another threshold (echo-top, echo-top:30), or the vertically integrated liquid (vil); "
    "seen from above, north up")
    ->group(group);
  command
    .add_option("--array", options.array,
      "With --map: what is drawn, as REF_age, REF_radars, REF_weight or REF_site (default: the "
      "moment)")
    ->type_name("NAME")
    ->group(group);
}

// A map is looked at from above unless the user says otherwise.
void FinishMap(const CLI::App& command, RenderOptions& options)
{
  scene::RenderRequest& request = options.request;
  if (!request.scene.plan)
  {
    if (!options.array.empty())
    {
      throw CLI::ValidationError("--array", "is of --map; write --map composite as well");
    }
    return;
  }
  request.scene.plan->array = options.array;
  const std::string moment = ToString(request.input.grid.moment);
  const bool ancillary = !options.array.empty() && options.array != moment;
  request.input.grid.beam.ancillary = request.input.grid.beam.ancillary || ancillary;
  request.camera.parallel = true;
  request.camera.azimuth = command.count("--azimuth") > 0 ? request.camera.azimuth : 180.0;
  request.camera.tilt = command.count("--tilt") > 0 ? request.camera.tilt : 90.0;
}

void AddMovie(CLI::App& command, scene::RenderRequest& request)
{
  constexpr char group[] = "Movie";
  AddNumberOption(command, "--fps", request.framesPerSecond, 1, 120, "NUMBER", "Frames a second")
    ->group(group);
  AddNumberOption(command, "--frames", request.frames, 0, 100'000, "NUMBER",
    "Number of frames; 0: one for each time")
    ->group(group);
  AddNumberOption(command, "--turn", request.turn, -36'000.0, 36'000.0, "DEGREES",
    "How far the camera goes round during the movie")
    ->group(group);
}

int RunRender(RenderOptions& options)
{
  ProgressBar bar("drawing", options.quiet);
  options.request.progress = [&bar](double fraction) { return bar.Update(fraction); };
  const scene::RenderReport report = RenderWithLibrary(options.request);
  bar.Clear();
  if (!options.quiet)
  {
    for (const auto& path : report.outputs)
    {
      std::cout << path.string() << '\n';
    }
  }
  for (const std::string& problem : report.problems)
  {
    std::cerr << problem << '\n';
  }
  return report.problems.empty() ? Done : DoneWithDamage;
}

} // namespace

void AddRenderCommand(CLI::App& program, CommandAction& action)
{
  const auto options = std::make_shared<RenderOptions>();
  scene::RenderRequest& request = options->request;
  CLI::App* command =
    program.add_subcommand("render", "Draw volumes, or radar files, as pictures or a movie");
  AddInputOptions(*command, request.input);
  AddParsedOption(*command, "-o,--output", request.output, ParseOutput, "FILE",
    "Picture (.png; one for each time, with the time in its name, when there are several) or movie "
    "(.ogv, or .mp4 where ffmpeg is installed)")
    ->required();
  AddQuietOption(*command, options->quiet);
  AddCameraOptions(*command, request.camera);
  AddPictureOptions(*command, request.size, request.scene);
  AddMap(*command, *options);
  AddMovie(*command, request);
  AddGridOptions(*command, request.input.grid);
  const auto run = [options, command, &action]
  {
    FinishMap(*command, *options);
    FinishDrawingOptions(*command, options->request.input, options->request.scene);
    action = [options] { return RunRender(*options); };
  };
  command->callback(run);
}

} // namespace nexrad::application

// SPDX-License-Identifier: BSD-3-Clause
#include "RenderCommand.h"

#include "ProgressBar.h"
#include "SceneLibrary.h"
#include "UnitOptions.h"

#include <CLI/CLI.hpp>

#include <iostream>
#include <memory>

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

scene::MapperChoice ParseMapper(const std::string& text)
{
  if (text != "texture-slice" && text != "ray-cast")
  {
    throw Error("'" + text + "' is no mapper; write texture-slice or ray-cast");
  }
  return text == "ray-cast" ? scene::MapperChoice::RayCast : scene::MapperChoice::TextureSlice;
}

double ParseRingSpacing(const std::string& text)
{
  const double spacing = ParseLength(text);
  if (spacing < 0.0 || (spacing > 0.0 && spacing < 1000.0))
  {
    throw Error("'" + text + "' is no distance of rings; write 1km or more, or 0 for none");
  }
  return spacing;
}

scene::PlanOptions ParsePlan(const std::string& text)
{
  scene::PlanOptions plan;
  if (text == "composite" || text == "lowest")
  {
    plan.level = text == "lowest" ? scene::PlanLevel::Lowest : scene::PlanLevel::Composite;
    return plan;
  }
  try
  {
    plan.level = scene::PlanLevel::Height;
    plan.height = ParseLength(text);
  }
  catch (const Error&)
  {
    throw Error("'" + text + "' is no map; write composite, lowest, or a height as in 3km");
  }
  return plan;
}

void AddCamera(CLI::App& command, scene::RenderRequest& request)
{
  constexpr char group[] = "Camera";
  scene::CameraView& camera = request.camera;
  AddNumberOption(command, "--azimuth", camera.azimuth, -3600.0, 3600.0, "DEGREES",
    "Where the camera stands, clockwise from north about the domain's centre: 180 looks north")
    ->group(group);
  AddNumberOption(command, "--tilt", camera.tilt, -90.0, 90.0, "DEGREES",
    "Height of the camera above the horizon; 90 looks straight down")
    ->group(group);
  AddNumberOption(command, "--zoom", camera.zoom, 0.01, 1000.0, "FACTOR",
    "1 shows the whole domain, 2 half of its width")
    ->group(group);
  command.add_flag("--parallel", camera.parallel, "Parallel in place of perspective projection")
    ->group(group);
}

void AddLook(CLI::App& command, scene::RenderRequest& request)
{
  constexpr char group[] = "Picture";
  AddParsedOption(command, "--size", request.size, ParsePictureSize, "WxH",
    "Width and height in pixels", "1280x720")
    ->group(group);
  AddNumberOption(command, "--exaggeration", request.scene.exaggeration, 0.1, 100.0, "FACTOR",
    "How much heights are stretched; the picture states it")
    ->group(group);
  AddParsedOption(command, "--mapper", request.scene.mapper, ParseMapper, "NAME",
    "texture-slice, or ray-cast: VTK's, for comparison", "texture-slice")
    ->group(group);
  AddNumberOption(command, "--slices", request.scene.slices, 1, 16384, "NUMBER",
    "Slices, or samples along the longest ray")
    ->group(group);
  command
    .add_option("--colours,--colors", request.colourTable,
      "Colour table: a heading, then lines dBZ,#rrggbb (default: the weather service's)")
    ->check(CLI::Validator(CLI::ExistingFile).description(""))
    ->type_name("FILE")
    ->group(group);
  AddParsedOption(command, "--rings", request.scene.ringSpacing, ParseRingSpacing, "LENGTH",
    "Rings of range about each radar at multiples of this, m or km; 0: none", "0")
    ->group(group);
}

void AddMap(CLI::App& command, RenderOptions& options)
{
  constexpr char group[] = "Map in place of the volume";
  AddParsedOption(command, "--map", options.request.scene.plan, ParsePlan, "WHICH",
    "Of each column the largest value (composite), the lowest that was scanned (lowest), or the "
    "one at a height above mean sea level, m or km; seen from above, north up")
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
  const std::string moment = ToString(request.grid.moment);
  const bool companion = !options.array.empty() && options.array != moment;
  request.grid.companions = request.grid.companions || companion;
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
  command
    ->add_option("input", request.inputs,
      "Volumes (.nxv, .nxv.series, .vti, or folders of them), or radar files and folders of them")
    ->required()
    ->type_name("INPUT");
  AddParsedOption(*command, "-o,--output", request.output, ParseOutput, "FILE",
    "Picture (.png; one for each time, with the time in its name, when there are several) or movie "
    "(.ogv, or .mp4 where ffmpeg is installed)")
    ->required();
  AddParsedOption(*command, "--time", request.time, ParseTime, "TIME",
    "Draw this time alone, in UTC, as in 2006-03-12T18:00");
  AddQuietOption(*command, options->quiet);
  AddCamera(*command, request);
  AddLook(*command, request);
  AddMap(*command, *options);
  AddMovie(*command, request);
  AddGridOptions(*command, request.grid);
  const auto run = [options, command, &action]
  {
    FinishMap(*command, *options);
    action = [options] { return RunRender(*options); };
  };
  command->callback(run);
}

} // namespace nexrad::application

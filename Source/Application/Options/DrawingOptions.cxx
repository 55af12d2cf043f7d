// SPDX-License-Identifier: BSD-3-Clause
#include "Options/DrawingOptions.h"

#include "Options/UnitOptions.h"
#include "Scene/DrawingSettings.h"

#include <CLI/CLI.hpp>

#include <string>

namespace nexrad::application
{
namespace
{

BoxRequest& BoxOf(InputRequest& request)
{
  return request.box ? *request.box : request.box.emplace();
}

// The box that is merged again in finer voxels.
void AddBoxOptions(CLI::App& command, InputRequest& request)
{
  constexpr char group[] = "Box in finer voxels";
  const auto takeFaces = [&request](const std::string& text)
  {
    PlaceUnit unit = PlaceUnit::OfVolume;
    BoxOf(request).faces = ParseBox(text, unit);
    request.boxUnit = unit;
  };
  const auto takeTime = [&request](const std::string& text)
  { BoxOf(request).followedFrom = ParseTime(text); };
  CLI::Option* faces = AddTextOption(command, "--box", takeFaces, "WEST,EAST,SOUTH,NORTH",
    "Draw this box of the domain in finer voxels: of radar files merged again in voxels of 250 m "
    "(larger where it is wider than 60 km), of .nxv files the smallest that fit. m or km east and "
    "north of the domain's centre; of a domain on axes of longitude and latitude degrees, as in "
    "-98deg,-97deg,35deg,36deg");
  faces->group(group);
  AddTextOption(command, "--follow-from", takeTime, "TIME",
    "The box is there at this time, in UTC; before and after, it has moved with the echo in it")
    ->needs(faces)
    ->group(group);
}

// A map is looked at from above unless the user says otherwise.
void FinishMap(const CLI::App& command, scene::DrawingRequest& request)
{
  const auto given = [&command](const char* name) { return command.count(name) > 0; };
  const std::string& array = request.scene.plan->array;
  const bool ancillary = !array.empty() && array != ToString(request.input.grid.moment);
  request.input.grid.beam.ancillary = request.input.grid.beam.ancillary || ancillary;
  const scene::CameraView above = scene::UsualBeside(request).camera;
  request.camera.parallel = !given("--perspective");
  request.camera.azimuth = given("--azimuth") ? request.camera.azimuth : above.azimuth;
  request.camera.tilt = given("--tilt") ? request.camera.tilt : above.tilt;
}

} // namespace

void AddTimedInputs(CLI::App& command, InputRequest& request, bool required)
{
  command
    .add_option("input", request.inputs,
      "Volumes (.nxv, .nxv.series, .vti, or folders of them), or radar files and folders of them")
    ->required(required)
    ->type_name("INPUT");
  AddParsedOption(command, "--time", request.time, ParseTime, "TIME",
    "Draw this time alone, in UTC, as in 2006-03-12T18:00");
}

void AddInputOptions(CLI::App& command, InputRequest& request, bool required)
{
  AddTimedInputs(command, request, required);
  AddBoxOptions(command, request);
}

void AddPageOptions(CLI::App& command, scene::DrawingOptions& options)
{
  for (const Setting<scene::DrawingOptions>& setting : scene::DrawingSettings())
  {
    if (setting.use == SettingUse::Result)
    {
      AddSetting(command, setting, options)->group(setting.group);
    }
  }
}

void AddDrawingOptions(CLI::App& command, scene::DrawingOptions& options)
{
  for (const Setting<scene::DrawingOptions>& setting : scene::DrawingSettings())
  {
    AddSetting(command, setting, options)->group(setting.group);
  }
}

void FinishDrawingOptions(const CLI::App& command, scene::DrawingRequest& request)
{
  CheckGiven<scene::DrawingOptions>(command, scene::DrawingSettings(), request);
  const scene::SceneOptions& options = request.scene;
  if (options.plan)
  {
    FinishMap(command, request);
  }
  // Numbers of a map are compared with those of other programs, which show what radars measured.
  request.input.grid.beam.sharpen = request.input.grid.beam.sharpen && !options.plan;
  request.input.momentNamed = command.count("--moment") > 0;
  request.input.colourBy = options.colourBy;
  request.maxGapGiven = command.count("--max-gap") > 0;
}

} // namespace nexrad::application

// SPDX-License-Identifier: BSD-3-Clause
#include "Options/DrawingOptions.h"

#include "Options/BoxOptions.h"
#include "Options/CuttingOptions.h"
#include "Options/GridOptions.h"
#include "Options/UnitOptions.h"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <optional>
#include <string>
#include <vector>

namespace nexrad::application
{
namespace
{

constexpr char pictureGroup[] = "Picture";

scene::MapperChoice ParseMapper(const std::string& text)
{
  if (text != "texture-slice" && text != "ray-cast")
  {
    throw Error("'" + text + "' is no mapper; write texture-slice or ray-cast");
  }
  return text == "ray-cast" ? scene::MapperChoice::RayCast : scene::MapperChoice::TextureSlice;
}

bool ParseClassification(const std::string& text)
{
  if (text != "pre-integrated" && text != "sampled")
  {
    throw Error("'" + text + "' is no classification; write pre-integrated or sampled");
  }
  return text == "pre-integrated";
}

bool ParseInterpolation(const std::string& text)
{
  if (text != "linear" && text != "nearest")
  {
    throw Error("'" + text + "' is no interpolation; write linear or nearest");
  }
  return text == "linear";
}

double ParseExaggeration(const std::string& text)
{
  const std::vector<double> factor = FindNumbers(text);
  if (factor.size() != 1 || factor[0] < 0.1 || factor[0] > 100.0)
  {
    throw Error("'" + text + "' is no factor of heights; write a number from 0.1 to 100");
  }
  return factor[0];
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

scene::ThemeChoice ParseTheme(const std::string& text)
{
  if (text != "dark" && text != "light")
  {
    throw Error("'" + text + "' is no theme; write dark or light");
  }
  return text == "light" ? scene::ThemeChoice::Light : scene::ThemeChoice::Dark;
}

scene::FrameChoice ParseFraming(const std::string& text)
{
  if (text != "echo" && text != "domain")
  {
    throw Error("'" + text + "' is no frame; write echo or domain");
  }
  return text == "domain" ? scene::FrameChoice::Domain : scene::FrameChoice::Echo;
}

double ParseOpacityDistance(const std::string& text)
{
  const double distance = ParseLength(text) / 1000.0;
  if (distance < 0.001 || distance > 1000.0)
  {
    throw Error("'" + text + "' is no length of opacities; write 1m to 1000km, as in 5km");
  }
  return distance;
}

// Settings that other options may change again, wherever they stand: it is added before them.
void AddLook(CLI::App& command, scene::SceneOptions& options)
{
  AddTextOption(
    command, "--look",
    [&options](const std::string& text)
    {
      if (text != "classic" && text != "usual")
      {
        throw Error("'" + text + "' is no look; write usual or classic");
      }
      if (text == "classic")
      {
        UseClassicLook(options);
      }
    },
    "NAME",
    "usual; or classic, the look of earlier versions: a dark, unlit scene about the whole domain, "
    "8 times as high, with 256 slices. Other options change what it sets")
    ->group(pictureGroup);
}

// One entry of a list of iso-values: "35" or "35:0.5". Empty where it is none.
std::optional<scene::IsoValue> ParseIsoValue(const std::string& text)
{
  const std::size_t colon = text.find(':');
  const std::vector<double> value = FindNumbers(text.substr(0, colon));
  const std::vector<double> opacity =
    colon == std::string::npos ? std::vector<double>{1.0} : FindNumbers(text.substr(colon + 1));
  if (value.size() != 1 || opacity.size() != 1 || opacity[0] <= 0.0 || opacity[0] > 1.0)
  {
    return std::nullopt;
  }
  scene::IsoValue isoValue;
  isoValue.value = value[0];
  isoValue.opacity = colon == std::string::npos ? std::nullopt : std::optional(opacity[0]);
  return isoValue;
}

scene::LightDirection ParseLightDirection(const std::string& text)
{
  const std::vector<double> angles = FindNumbers(text);
  if (angles.size() != 2 || std::abs(angles[0]) > 360.0 || std::abs(angles[1]) > 90.0)
  {
    throw Error("'" + text +
                "' is no direction of light; write degrees clockwise from north, -360 to 360, and "
                "above the horizon, -90 to 90, as in 250,45");
  }
  return {angles[0], angles[1]};
}

// The map of that name, which a colon and the threshold of its echo top in dBZ may follow. False
// where the text begins otherwise.
bool ParseThresholdMap(const std::string& text, const std::string& name, double& threshold)
{
  if (text.compare(0, name.size(), name) != 0)
  {
    return false;
  }
  if (text.size() == name.size())
  {
    return true;
  }
  const std::vector<double> written = FindNumbers(text.substr(name.size() + 1));
  if (text[name.size()] != ':' || written.size() != 1 || std::abs(written[0]) > 100.0)
  {
    throw Error("'" + text + "' is no " + name + "; write " + name + ", or " + name +
                ":30 for an echo top of 30 dBZ");
  }
  threshold = written[0];
  return true;
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
  if (ParseThresholdMap(text, "echo-top", plan.threshold))
  {
    plan.level = scene::PlanLevel::EchoTop;
    return plan;
  }
  if (ParseThresholdMap(text, "vil-density", plan.threshold))
  {
    plan.level = scene::PlanLevel::LiquidDensity;
    return plan;
  }
  try
  {
    plan.level = scene::PlanLevel::Height;
    plan.height = ParseLength(text);
  }
  catch (const Error&)
  {
    throw Error("'" + text +
                "' is no map; write composite, lowest, echo-top, vil, vil-density, or a height as "
                "in 3km");
  }
  return plan;
}

// "35.3,-97.3" or "35.3,-97.3,4km": latitude, longitude and height.
scene::LookAt ParseLookAt(const std::string& text)
{
  const bool higher = SplitAtCommas(text).size() == 3;
  const std::size_t last = text.rfind(',');
  const std::vector<double> place = FindNumbers(higher ? text.substr(0, last) : text);
  if (place.size() != 2 || std::abs(place[0]) > 90.0 || std::abs(place[1]) > 360.0)
  {
    throw Error("'" + text +
                "' is no place to look at; write latitude and longitude in degrees, and the height "
                "above mean sea level if it is not 0, as in 35.3,-97.3,4km");
  }
  return {{place[1], place[0], higher ? ParseLength(text.substr(last + 1)) : 0.0}, true};
}

void AddPictureOptions(CLI::App& command, std::array<int, 2>& size, scene::SceneOptions& options)
{
  const char* const group = pictureGroup;
  AddLook(command, options);
  AddParsedOption(
    command, "--size", size, ParsePictureSize, "WxH", "Width and height in pixels", "1280x720")
    ->group(group);
  AddParsedOption(command, "--mapper", options.mapper, ParseMapper, "NAME",
    "texture-slice, or ray-cast: VTK's, for comparison", "texture-slice")
    ->group(group);
  AddParsedOption(command, "--classification", options.preIntegration, ParseClassification, "NAME",
    "How a slice finds its colours: pre-integrated, from all scalars between its front and its "
    "back; "
    "or sampled, from one scalar, as VTK's ray caster does",
    "pre-integrated")
    ->group(group);
  AddParsedOption(command, "--interpolation", options.linearInterpolation, ParseInterpolation,
    "NAME", "Between voxels: linear; or nearest, which shows each voxel as a box of one value",
    "linear")
    ->group(group);
  AddNumberOption(command, "--slices", options.slices, 0, 16384, "NUMBER",
    "Slices, or samples along the longest ray, up to 16384; 0: about three for every eight voxels "
    "along the view")
    ->group(group);
  AddAppearanceOptions(command, options);
  command
    .add_option("--colour-by,--color-by", options.colourBy,
      "Colours from another array than the moment, which then gives the opacities alone: a moment, "
      "as VEL, or an ancillary array, as REF_age, REF_radars, REF_weight or REF_site. Brown: no "
      "value")
    ->type_name("ARRAY")
    ->group(group);
  AddNumberOption(command, "--shadow", options.light.shadow, 0.0, 1.0, "STRENGTH",
    "How dark the shadows are that the volume casts on itself and on the ground; 0: none")
    ->group(group);
  AddNumberOption(command, "--occlusion", options.light.occlusion, 0.0, 1.0, "STRENGTH",
    "How dark the volume and the ground are where they see little of the sky; 0: no effect")
    ->group(group);
  AddParsedOption(command, "--light", options.light.direction, ParseLightDirection,
    "AZIMUTH,ELEVATION",
    "Where the light of the shadows comes from, degrees clockwise from north and above the horizon "
    "of the stretched scene",
    "250,45")
    ->group(group);
  AddParsedOption(command, "--rings", options.ringSpacing, ParseRingSpacing, "LENGTH",
    "Rings of range about each radar at multiples of this, m or km; 0: none", "0")
    ->group(group);
  command
    .add_flag_callback(
      "--no-walls", [&options] { options.heightWalls = false; },
      "No lines of equal height on the walls behind the volume")
    ->group(group);
  command.add_flag("--names", options.placeNames, "Names of states and provinces on the map")
    ->group(group);
  AddCuttingOptions(command, options.cut);
}

void AddMapOptions(CLI::App& command, scene::SceneOptions& options)
{
  constexpr char group[] = "Map in place of the volume";
  AddParsedOption(command, "--map", options.plan, ParsePlan, "WHICH",
    "Of each column the largest value (composite; of VEL the fastest), the lowest that was scanned "
    "(lowest), the one at a height above mean sea level, m or km, the height of the echo top at 18 "
    "dBZ or another threshold (echo-top, echo-top:30), the vertically integrated liquid (vil), or "
    "the liquid through the height of the echo top (vil-density, vil-density:30); seen from above, "
    "north up")
    ->group(group);
  command
    .add_option("--array",
      "With --map: what is drawn, as REF_age, REF_radars, REF_weight or REF_site (default: the "
      "moment)")
    ->type_name("NAME")
    ->group(group);
  command.add_flag("--perspective", "With --map: perspective in place of parallel projection")
    ->excludes("--parallel")
    ->group(group);
}

// A map is looked at from above unless the user says otherwise.
void FinishMap(const CLI::App& command, scene::DrawingRequest& request)
{
  const auto given = [&command](const char* name) { return command.count(name) > 0; };
  if (!request.scene.plan)
  {
    for (const char* name : {"--array", "--perspective"})
    {
      if (given(name))
      {
        throw CLI::ValidationError(name, "is of --map; write --map composite as well");
      }
    }
    return;
  }
  const std::string array = given("--array") ? command["--array"]->as<std::string>() : "";
  request.scene.plan->array = array;
  const std::string moment = ToString(request.input.grid.moment);
  const bool ancillary = !array.empty() && array != moment;
  request.input.grid.beam.ancillary = request.input.grid.beam.ancillary || ancillary;
  request.camera.parallel = !given("--perspective");
  request.camera.azimuth = given("--azimuth") ? request.camera.azimuth : MapAzimuth;
  request.camera.tilt = given("--tilt") ? request.camera.tilt : MapTilt;
}

} // namespace

std::vector<scene::IsoValue> ParseIsoValues(const std::string& text)
{
  constexpr char right[] = "; write values, each with the opacity of its surface above 0 and up to "
                           "1 if it is not to have the usual one, as in 20:0.3,40:0.6,50:1";
  std::vector<scene::IsoValue> isoValues;
  for (const std::string& entry : SplitAtCommas(text))
  {
    const std::optional<scene::IsoValue> isoValue = ParseIsoValue(entry);
    if (!isoValue)
    {
      throw Error("'" + entry + "' in '" + text + "' is no iso-value" + right);
    }
    const bool twice = std::any_of(isoValues.begin(), isoValues.end(),
      [&](const scene::IsoValue& other) { return other.value == isoValue->value; });
    if (twice)
    {
      throw Error("'" + text + "' has the value of '" + entry + "' twice" + right);
    }
    isoValues.push_back(*isoValue);
  }
  return isoValues;
}

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

void AddAppearanceOptions(CLI::App& command, scene::SceneOptions& options)
{
  const char* const group = pictureGroup;
  AddParsedOption(command, "--exaggeration", options.exaggeration, ParseExaggeration, "FACTOR",
    "How much heights are stretched, 0.1 to 100; the picture states it (default: by the size of "
    "the frame, 3 for what one radar sees, up to 8 for many radars)")
    ->group(group);
  AddParsedOption(command, "--frame", options.framing, ParseFraming, "WHAT",
    "What fills the picture: echo, with the radars near it, at all times of a movie; or domain",
    "echo")
    ->group(group);
  command
    .add_option("--preset", options.preset,
      "Colours and opacities: six of REF, then one of each other moment (default: the first of "
      "the moment)")
    ->check(CLI::IsMember(
      std::vector<std::string>(std::begin(scene::presetNames), std::end(scene::presetNames))))
    ->group(group);
  AddParsedOption(command, "--iso-values", options.isoValues, ParseIsoValues, "VALUE[:OPACITY],...",
    "Draw the surfaces of these values in the unit of the moment, as m/s, whatever unit the colour "
    "bar has, with the colours of the preset, as in 20:0.3,40:0.6,50:1; usual opacities: from 0.35 "
    "for the lowest to 0.95 for the highest")
    ->group(group);
  command
    .add_option("--colours,--colors", options.colours,
      "Colours in place of the preset's, and opacities if the file has any (with --colour-by, "
      "those "
      "of its moment, without opacities): ParaView's .json, a .pal table, or .csv with a heading, "
      "then lines dBZ,#rrggbb")
    ->check(CLI::Validator(CLI::ExistingFile).description(""))
    ->type_name("FILE")
    ->group(group);
  command
    .add_option("--opacities", options.opacities,
      "Opacities alone, in place of those of the preset and of --colours: such a file; with "
      "--colour-by, of the moment that is shown")
    ->check(CLI::Validator(CLI::ExistingFile).description(""))
    ->type_name("FILE")
    ->group(group);
  AddParsedOption(command, "--opacity-distance", options.opacityDistance, ParseOpacityDistance,
    "LENGTH",
    "The length along a ray to which opacities belong (default: so that the echo is seen neither "
    "faint nor solid)")
    ->group(group);
  AddParsedOption(command, "--theme", options.theme, ParseTheme, "NAME",
    "light: dark letters over a pale ground; dark: light letters over a grey one", "light")
    ->group(group);
}

void AddCameraOptions(CLI::App& command, scene::CameraView& camera)
{
  constexpr char group[] = "Camera";
  AddNumberOption(command, "--azimuth", camera.azimuth, -3600.0, 3600.0, "DEGREES",
    "Where the camera stands, clockwise from north about the frame: 180 looks north")
    ->group(group);
  AddNumberOption(command, "--tilt", camera.tilt, -90.0, 90.0, "DEGREES",
    "Height of the camera above the horizon; 90 looks straight down")
    ->group(group);
  AddNumberOption(command, "--zoom", camera.zoom, 0.01, 1000.0, "FACTOR",
    "1 shows the whole frame, 2 half of its width")
    ->group(group);
  AddParsedOption(command, "--look-at", camera.lookAt, ParseLookAt, "LATITUDE,LONGITUDE[,HEIGHT]",
    "What is in the middle of the picture, as in 35.3,-97.3,4km (default: the frame fills the "
    "picture)")
    ->group(group);
  command.add_flag("--parallel", camera.parallel, "Parallel in place of perspective projection")
    ->group(group);
}

void AddDrawingOptions(CLI::App& command, scene::DrawingRequest& request)
{
  AddCameraOptions(command, request.camera);
  AddPictureOptions(command, request.size, request.scene);
  AddMapOptions(command, request.scene);
}

void FinishDrawingOptions(const CLI::App& command, scene::DrawingRequest& request)
{
  const scene::SceneOptions& options = request.scene;
  if (options.plan && !options.colourBy.empty())
  {
    throw CLI::ValidationError("--colour-by", "is of a volume; --array is what a map shows");
  }
  if (options.plan && !options.isoValues.empty())
  {
    throw CLI::ValidationError("--iso-values", "are of a volume; a map has no surfaces");
  }
  FinishMap(command, request);
  // Numbers of a map are compared with those of other programs, which show what radars measured.
  request.input.grid.beam.sharpen = request.input.grid.beam.sharpen && !options.plan;
  request.input.momentNamed = command.count("--moment") > 0;
  request.input.colourBy = options.colourBy;
  request.maxGapGiven = command.count("--max-gap") > 0;
}

} // namespace nexrad::application

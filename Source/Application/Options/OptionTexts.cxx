// SPDX-License-Identifier: BSD-3-Clause
#include "Options/OptionTexts.h"

#include "Options/DrawingOptions.h"
#include "Options/GridOptions.h"
#include "nexrad/Geometry/Angles.h"
#include "nexrad/System/Error.h"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <array>
#include <cmath>

namespace nexrad::application
{
namespace
{

class OptionList
{
public:
  void Add(const std::string& name, const std::string& value) { texts.push_back({name, value}); }
  void AddFlag(const std::string& name, bool on)
  {
    if (on)
    {
      texts.push_back({name, ""});
    }
  }
  void AddUnless(double usual, const std::string& name, double value)
  {
    if (value != usual)
    {
      this->Add(name, NumberText(value));
    }
  }
  void AddIfAny(const std::string& name, const std::string& value)
  {
    if (!value.empty())
    {
      this->Add(name, value);
    }
  }
  std::vector<OptionText> Take() { return std::move(texts); }

private:
  std::vector<OptionText> texts;
};

std::string MapTextOf(const scene::PlanOptions& plan)
{
  switch (plan.level)
  {
  case scene::PlanLevel::Lowest:
    return "lowest";
  case scene::PlanLevel::Height:
    return LengthText(plan.height);
  case scene::PlanLevel::EchoTop:
    return "echo-top:" + NumberText(plan.threshold);
  case scene::PlanLevel::Liquid:
    return "vil";
  case scene::PlanLevel::LiquidDensity:
    return "vil-density:" + NumberText(plan.threshold);
  default:
    return "composite";
  }
}

std::string IsoValuesTextOf(const std::vector<scene::IsoValue>& isoValues)
{
  std::string text;
  for (const scene::IsoValue& isoValue : isoValues)
  {
    text += (text.empty() ? "" : ",") + NumberText(isoValue.value);
    text += isoValue.opacity ? ":" + NumberText(*isoValue.opacity) : "";
  }
  return text;
}

void AddCamera(const scene::CameraView& camera, bool map, OptionList& options)
{
  const scene::CameraView usual;
  options.AddUnless(map ? MapAzimuth : usual.azimuth, "--azimuth", camera.azimuth);
  options.AddUnless(map ? MapTilt : usual.tilt, "--tilt", camera.tilt);
  options.AddUnless(usual.zoom, "--zoom", camera.zoom);
  if (camera.lookAt && camera.lookAt->geographic)
  {
    const auto& [longitude, latitude, height] = camera.lookAt->place;
    options.Add(
      "--look-at", NumberText(latitude) + "," + NumberText(longitude) + "," + LengthText(height));
  }
  options.AddFlag("--parallel", !map && camera.parallel);
  options.AddFlag("--perspective", map && !camera.parallel);
}

constexpr double metresPerKilometre = 1000.0;

void AddVolume(const scene::SceneOptions& scene, OptionList& options)
{
  const scene::SceneOptions usual;
  if (scene.mapper == scene::MapperChoice::RayCast)
  {
    options.Add("--mapper", "ray-cast");
  }
  if (!scene.preIntegration)
  {
    options.Add("--classification", "sampled");
  }
  if (!scene.linearInterpolation)
  {
    options.Add("--interpolation", "nearest");
  }
  if (scene.slices > 0)
  {
    options.Add("--slices", std::to_string(scene.slices));
  }
  if (scene.opacityDistance)
  {
    options.Add("--opacity-distance", LengthText(metresPerKilometre * *scene.opacityDistance));
  }
  if (scene.framing == scene::FrameChoice::Domain)
  {
    options.Add("--frame", "domain");
  }
  options.AddIfAny("--preset", scene.preset);
  options.AddIfAny("--iso-values", IsoValuesTextOf(scene.isoValues));
  if (!scene.colours.empty())
  {
    options.Add("--colours", std::filesystem::absolute(scene.colours).string());
  }
  if (!scene.opacities.empty())
  {
    options.Add("--opacities", std::filesystem::absolute(scene.opacities).string());
  }
  options.AddIfAny("--colour-by", scene.colourBy);
  options.AddUnless(usual.light.shadow, "--shadow", scene.light.shadow);
  options.AddUnless(usual.light.occlusion, "--occlusion", scene.light.occlusion);
  const scene::LightDirection& from = scene.light.direction;
  const scene::LightDirection& usualFrom = usual.light.direction;
  if (from.azimuth != usualFrom.azimuth || from.elevation != usualFrom.elevation)
  {
    options.Add("--light", NumberText(from.azimuth) + "," + NumberText(from.elevation));
  }
}

void AddSurroundings(const scene::SceneOptions& scene, OptionList& options)
{
  if (scene.exaggeration)
  {
    options.Add("--exaggeration", NumberText(*scene.exaggeration));
  }
  if (scene.ringSpacing > 0.0)
  {
    options.Add("--rings", LengthText(scene.ringSpacing));
  }
  if (scene.theme == scene::ThemeChoice::Dark)
  {
    options.Add("--theme", "dark");
  }
  options.AddFlag("--no-walls", !scene.heightWalls);
  options.AddFlag("--names", scene.placeNames);
  if (scene.plan)
  {
    options.Add("--map", MapTextOf(*scene.plan));
    options.AddIfAny("--array", scene.plan->array);
  }
}

// Of a direction that was computed from an angle with few digits.
std::string AngleTextOf(double radians)
{
  constexpr double digits = 1e9;
  return NumberText(std::round(digits * radians / RadiansPerDegree) / digits);
}

std::string ClipTextOf(const scene::CutPlane& plane, PlaceUnit unit)
{
  const auto& [x, y, height] = plane.origin;
  const auto& [east, north, up] = plane.normal;
  const double metres = unit == PlaceUnit::Degrees ? MetresPerDegree : 1.0;
  const std::string upright =
    PlacesText(std::array{x, y}, unit) + "," + AngleTextOf(std::atan2(east, north));
  return up == 0.0 ? upright
                   : upright + "," + LengthText(height) + "," +
                       AngleTextOf(std::atan2(metres * up, std::hypot(east, north)));
}

void AddCut(const scene::CutOptions& cut, OptionList& options)
{
  if (cut.box)
  {
    const auto& [west, east, south, north, bottom, top] = *cut.box;
    options.Add("--crop", PlacesText(std::array{west, east, south, north}, cut.unit) + "," +
                            LengthText(bottom) + "," + LengthText(top));
  }
  if (cut.plane)
  {
    options.Add("--clip", ClipTextOf(*cut.plane, cut.unit));
  }
  if (cut.section)
  {
    const auto& [from, to] = *cut.section;
    options.Add("--section", PlacesText(std::array{from[0], from[1], to[0], to[1]}, cut.unit));
  }
}

void AddBox(const InputRequest& input, OptionList& options)
{
  if (!input.box)
  {
    return;
  }
  const bool given = input.boxUnit != PlaceUnit::OfVolume;
  const PlaceUnit unit = given ? input.boxUnit : PlaceUnitOf(input.grid.grid.axes);
  options.Add("--box", PlacesText(input.box->faces, unit));
  if (input.box->followedFrom)
  {
    options.Add("--follow-from", FormatIso8601(*input.box->followedFrom));
  }
}

// What a map makes of the settings by itself is left out (FinishDrawingOptions). The moments of
// volume files are those of the files, unless they are named.
void AddMerging(const scene::DrawingRequest& request, OptionList& options)
{
  MergeOptions merging = request.input.grid;
  const std::optional<scene::PlanOptions>& plan = request.scene.plan;
  merging.beam.sharpen = merging.beam.sharpen || plan;
  const bool ofMap = plan && !plan->array.empty() && plan->array != ToString(merging.moment);
  merging.beam.ancillary = merging.beam.ancillary && !ofMap;
  for (const OptionText& text : ToTexts(MergeSettings(), merging))
  {
    if (text.name != "--moment")
    {
      options.Add(text.name, text.value);
    }
  }
  if (request.input.momentNamed)
  {
    options.Add("--moment", MomentsValue().text(merging.Moments()));
  }
}

// CLI11 would take a value that begins with a minus for an option.
std::string ArgumentOf(const OptionText& text)
{
  return text.value.empty() ? text.name : text.name + "=" + text.value;
}

} // namespace

std::vector<OptionText> OptionTextsOf(const scene::DrawingRequest& request)
{
  OptionList options;
  if (request.input.time)
  {
    options.Add("--time", FormatIso8601(*request.input.time));
  }
  if (request.size != scene::DrawingRequest().size)
  {
    options.Add("--size", std::to_string(request.size[0]) + "x" + std::to_string(request.size[1]));
  }
  AddCamera(request.camera, request.scene.plan.has_value(), options);
  AddVolume(request.scene, options);
  AddSurroundings(request.scene, options);
  AddCut(request.scene.cut, options);
  AddBox(request.input, options);
  AddMerging(request, options);
  return options.Take();
}

void ParseOptionTexts(const std::vector<OptionText>& texts, scene::DrawingRequest& request)
{
  CLI::App command;
  command.set_help_flag();
  InputRequest input = request.input;
  AddInputOptions(command, input, false);
  AddDrawingOptions(command, request);
  AddGridOptions(command, input.grid);
  std::vector<std::string> arguments;
  for (const OptionText& text : texts)
  {
    if (text.name.rfind("--", 0) != 0 || command.get_option_no_throw(text.name) == nullptr)
    {
      throw Error(text.name + ": there is no such option; nexrad3d render --help lists them");
    }
    arguments.insert(arguments.begin(), ArgumentOf(text)); // CLI11 takes the last one first
  }
  try
  {
    command.parse(arguments);
    input.inputs = request.input.inputs;
    request.input = input;
    FinishDrawingOptions(command, request);
  }
  catch (const CLI::Error& error)
  {
    throw Error(error.what());
  }
}

std::string QuoteForShell(const std::string& word)
{
  constexpr char plain[] =
    "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_./:,=+@%-";
  if (!word.empty() && word.find_first_not_of(plain) == std::string::npos)
  {
    return word;
  }
  std::string quoted = "'";
  for (const char letter : word)
  {
    quoted += letter == '\'' ? std::string("'\\''") : std::string(1, letter);
  }
  return quoted + "'";
}

std::string RenderCommandOf(
  const scene::DrawingRequest& request, const std::filesystem::path& output)
{
  std::string command = "nexrad3d render";
  for (const std::filesystem::path& input : request.input.inputs)
  {
    command += " " + QuoteForShell(std::filesystem::absolute(input).string());
  }
  command += " -o " + QuoteForShell(output.string());
  for (const OptionText& text : OptionTextsOf(request))
  {
    const bool minus = !text.value.empty() && text.value.front() == '-';
    command += " " + text.name;
    command += text.value.empty() ? "" : (minus ? "=" : " ") + QuoteForShell(text.value);
  }
  return command;
}

} // namespace nexrad::application

// SPDX-License-Identifier: BSD-3-Clause
#include "Options/DrawingOptions.h"

#include "Options/UnitOptions.h"

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
  const bool ancillary = !array.empty() && array != ToString(request.input.grid.moments.front());
  request.input.grid.beam.ancillary = request.input.grid.beam.ancillary || ancillary;
  const scene::CameraView above = scene::UsualBeside(request).camera;
  request.camera.parallel = !given("--perspective");
  request.camera.azimuth = given("--azimuth") ? request.camera.azimuth : above.azimuth;
  request.camera.tilt = given("--tilt") ? request.camera.tilt : above.tilt;
}

// As the mouse makes it, a box has the unit of the domain.
void AddBox(const InputRequest& input, std::vector<OptionText>& texts)
{
  if (!input.box)
  {
    return;
  }
  const bool given = input.boxUnit != PlaceUnit::OfVolume;
  const PlaceUnit unit = given ? input.boxUnit : PlaceUnitOf(input.grid.grid.axes);
  texts.push_back({"--box", PlacesText(input.box->faces, unit)});
  if (input.box->followedFrom)
  {
    texts.push_back({"--follow-from", FormatIso8601(*input.box->followedFrom)});
  }
}

// What a map makes of the settings by itself is left out (FinishDrawingOptions). The moments of
// volume files are those of the files, unless they are named.
void AddMerging(const scene::DrawingRequest& request, std::vector<OptionText>& texts)
{
  MergeOptions merging = request.input.grid;
  const std::optional<scene::PlanOptions>& plan = request.scene.plan;
  merging.beam.sharpen = merging.beam.sharpen || plan;
  const bool ofMap =
    plan && !plan->array.empty() && plan->array != ToString(merging.moments.front());
  merging.beam.ancillary = merging.beam.ancillary && !ofMap;
  for (const OptionText& text : ToTexts(MergeSettings(), merging))
  {
    if (text.name != "--moment")
    {
      texts.push_back(text);
    }
  }
  if (request.input.momentNamed)
  {
    texts.push_back({"--moment", MomentsValue().text(merging.moments)});
  }
}

// CLI11 would take a value that begins with a minus for an option.
std::string ArgumentOf(const OptionText& text)
{
  return text.value.empty() ? text.name : text.name + "=" + text.value;
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
  request.input.textureMemory = options.textureMemory;
  request.maxGapGiven = command.count("--max-gap") > 0;
}

std::vector<OptionText> OptionTextsOf(const scene::DrawingRequest& request)
{
  std::vector<OptionText> texts;
  if (request.input.time)
  {
    texts.push_back({"--time", FormatIso8601(*request.input.time)});
  }
  const std::vector<OptionText> drawing =
    ToTexts<scene::DrawingOptions>(scene::DrawingSettings(), request, scene::UsualBeside(request));
  texts.insert(texts.end(), drawing.begin(), drawing.end());
  AddBox(request.input, texts);
  AddMerging(request, texts);
  return texts;
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

// SPDX-License-Identifier: BSD-3-Clause
#include "Options/OptionTexts.h"

#include "Options/DrawingOptions.h"
#include "Options/GridOptions.h"
#include "Scene/DrawingSettings.h"
#include "nexrad/System/Error.h"

#include <CLI/CLI.hpp>

#include <string>

namespace nexrad::application
{
namespace
{

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
  const bool ofMap = plan && !plan->array.empty() && plan->array != ToString(merging.moment);
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
    texts.push_back({"--moment", MomentsValue().text(merging.Moments())});
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

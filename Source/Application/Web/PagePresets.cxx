// SPDX-License-Identifier: BSD-3-Clause
#include "Web/PagePresets.h"

#include "Scene/Scales/ColourScale.h"
#include "Scene/VolumeAppearance.h"
#include "Web/PageCode.h"
#include "Web/RoundedNumber.h"
#include "vtkColorTransferFunction.h"
#include "vtkNew.h"
#include "vtkNexradTransferFunction.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>

namespace nexrad::application
{
namespace
{

using Json = nlohmann::ordered_json;

constexpr int samplesPerByte = 2; // as in Scripts/table.js
constexpr int samples = 255 * samplesPerByte + 1;
constexpr double searchStep = 0.01; // of the range of a preset
constexpr int opacityDigits = 5;    // low opacities add up along a ray

Json MakeSamples(vtkNexradTransferFunction* function, const PageCode& code)
{
  vtkNew<vtkColorTransferFunction> colours;
  function->FillColorFunction(colours);
  Json json = Json::array();
  for (int sample = 0; sample < samples; ++sample)
  {
    const double value = code.first + code.step * sample / samplesPerByte;
    std::array<double, 3> colour{};
    colours->GetColor(value, colour.data());
    for (const double part : colour)
    {
      json.push_back(Rounded(part, ColourDigits));
    }
    json.push_back(
      Rounded(function->Evaluate(vtkNexradTransferFunction::OPACITY, value), opacityDigits));
  }
  return json;
}

Json MakeSurfaces(vtkNexradTransferFunction* function)
{
  Json json = Json::array();
  for (int i = 0; i < function->GetNumberOfIsoValues(); ++i)
  {
    const double value = function->GetIsoValue(i);
    const double opacity = function->Evaluate(vtkNexradTransferFunction::OPACITY, value);
    json.push_back({value, Rounded(opacity, ColourDigits)});
  }
  return json;
}

Json MakeColour(const scene::Colour& colour)
{
  Json json = Json::array();
  for (const double part : colour)
  {
    json.push_back(Rounded(part, ColourDigits));
  }
  return json;
}

Json MakeBins(const scene::ColourTable& table)
{
  Json json = Json::array();
  for (const scene::ColourBin& bin : table)
  {
    json.push_back({{"from", bin.from}, {"colour", MakeColour(bin.colour)}});
    if (bin.ramp)
    {
      json.back()["to"] = bin.ramp->at;
      json.back()["upper"] = MakeColour(bin.ramp->colour);
    }
  }
  return json;
}

// What the bar writes of a look whose colour table has a unit of its own.
Json MakeLabels(const scene::ColourScale& scale)
{
  return {{"unit", scale.unit}, {"factor", scale.factor}, {"offset", scale.offset},
    {"step", scale.step}, {"decimals", scale.decimals}};
}

} // namespace

PagePresets PresetsOf(const scene::SceneOptions& options, const std::string& array)
{
  PagePresets presets;
  const bool own =
    !options.colours.empty() || !options.opacities.empty() || !options.isoValues.empty();
  const auto chosen = scene::MakeTransferFunction(options, array); // throws for a wrong preset
  if (own)
  {
    presets.all.push_back({"own", chosen});
  }
  const char* name = nullptr;
  for (int i = 0; (name = vtkNexradTransferFunction::FindPreset(array.c_str(), i)) != nullptr; ++i)
  {
    scene::SceneOptions wanted;
    wanted.preset = name;
    presets.first = !own && options.preset == name ? presets.all.size() : presets.first;
    presets.all.push_back({name, scene::MakeTransferFunction(wanted, array)});
  }
  if (presets.all.empty()) // an array that is no moment
  {
    presets.all.push_back({"usual", chosen});
  }
  return presets;
}

double LeastVisible(vtkNexradTransferFunction* function)
{
  std::array<double, 2> range{};
  function->GetRange(range.data());
  if (function->GetNumberOfIsoValues() > 0)
  {
    double least = function->GetIsoValue(0);
    for (int i = 1; i < function->GetNumberOfIsoValues(); ++i)
    {
      least = std::min(least, function->GetIsoValue(i));
    }
    return least;
  }
  const double step = searchStep * (range[1] - range[0]);
  double value = range[0];
  while (value < range[1] &&
         !(function->Evaluate(vtkNexradTransferFunction::OPACITY, value + step) > 0.0))
  {
    value += step;
  }
  return value;
}

double LeastVisible(const PagePresets& presets)
{
  const auto usual = std::find_if(presets.all.begin(), presets.all.end(),
    [](const PagePreset& preset) { return preset.name != "own"; });
  const double least = LeastVisible(presets.all[presets.first].function);
  return usual == presets.all.end() ? least : std::min(least, LeastVisible(usual->function));
}

Json MakePresetsJson(const PagePresets& presets, const std::string& array, const PageCode& code)
{
  Json json = Json::array();
  for (const PagePreset& preset : presets.all)
  {
    if (code.floor && LeastVisible(preset.function) < *code.floor)
    {
      continue;
    }
    const auto scale = scene::ScaleOf(array, preset.function);
    json.push_back({{"name", preset.name}, {"surfaces", MakeSurfaces(preset.function)},
      {"bins", MakeBins(scale.bins)}, {"labels", MakeLabels(scale)},
      {"samples", MakeSamples(preset.function, code)}});
  }
  return json;
}

} // namespace nexrad::application

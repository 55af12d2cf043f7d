// SPDX-License-Identifier: BSD-3-Clause
#include "Web/PageScene.h"

#include "Scene/Captions/Captions.h"
#include "Scene/Captions/EchoShown.h"
#include "Scene/EchoFraming.h"
#include "Scene/Frame/VolumeInformation.h"
#include "Scene/Map/GroundPicture.h"
#include "Scene/Map/PlacedMap.h"
#include "Scene/Scales/ColourScale.h"
#include "Scene/Shapes/Theme.h"
#include "Scene/VolumeAppearance.h"
#include "Web/PageCode.h"
#include "nexrad/Settings/ValueTexts.h"
#include "nexrad/System/Error.h"
#include "vtkColorTransferFunction.h"
#include "vtkNew.h"
#include "vtkNexradImageConversion.h"
#include "vtkNexradTransferFunction.h"

#include <vtkImageData.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace nexrad::application
{

namespace
{

using Json = nlohmann::ordered_json;

/// A number rounded to so many digits after the decimal point, for texts that are to be short.
double Rounded(double value, int digits)
{
  const double factor = std::pow(10.0, digits);
  return std::round(value * factor) / factor;
}

constexpr int samplesPerByte = 2; // as in Scripts/table.js
constexpr int samples = 255 * samplesPerByte + 1;
constexpr double searchStep = 0.01; // of the range of a preset
constexpr int colourDigits = 4;     // of a part of a colour, or an opacity that stands alone
constexpr int opacityDigits = 5;    // low opacities add up along a ray

Json MakeSamples(vtkNexradTransferFunction* function, const PageCode& code)
{
  vtkNew<vtkColorTransferFunction> colours;
  function->FillColorFunction(colours);
  Json json = Json::array();
  for (int sample = 0; sample < samples; ++sample)
  {
    const double value = code.first + code.step * sample / samplesPerByte;
    scene::Colour colour{};
    colours->GetColor(value, colour.data());
    for (const double part : colour)
    {
      json.push_back(Rounded(part, colourDigits));
    }
    json.push_back(
      Rounded(function->Evaluate(vtkNexradTransferFunction::OPACITY, value), opacityDigits));
  }
  return json;
}

Json MakeSurfaces(vtkNexradTransferFunction* function)
{
  Json json = Json::array();
  for (const auto& [value, opacity] : scene::IsoValuesOf(function))
  {
    json.push_back({value, Rounded(*opacity, colourDigits)});
  }
  return json;
}

Json MakeColour(const scene::Colour& colour)
{
  Json json = Json::array();
  for (const double part : colour)
  {
    json.push_back(Rounded(part, colourDigits));
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

// The presets of the moment and, before them, "own" where the options have colours, opacities or
// iso-values of their own. Throws Error as scene::MakeTransferFunction does.
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

// The least value at which a preset has an opacity above 0, or the least of its iso-values.
double LeastVisible(vtkNexradTransferFunction* function)
{
  const std::vector<scene::IsoValue> isoValues = scene::IsoValuesOf(function);
  if (!isoValues.empty())
  {
    return std::min_element(isoValues.begin(), isoValues.end(),
      [](const scene::IsoValue& a, const scene::IsoValue& b) { return a.value < b.value; })
      ->value;
  }
  std::array<double, 2> range{};
  function->GetRange(range.data());
  const double step = searchStep * (range[1] - range[0]);
  double value = range[0];
  while (value < range[1] &&
         !(function->Evaluate(vtkNexradTransferFunction::OPACITY, value + step) > 0.0))
  {
    value += step;
  }
  return value;
}

// The least value that the preset of the options shows, or the first preset of its moment.
double LeastVisible(const PagePresets& presets)
{
  const auto usual = std::find_if(presets.all.begin(), presets.all.end(),
    [](const PagePreset& preset) { return preset.name != "own"; });
  const double least = LeastVisible(presets.all[presets.first].function);
  return usual == presets.all.end() ? least : std::min(least, LeastVisible(usual->function));
}

// The presets as the page's script takes them; without those that show values below the floor of
// the code.
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

constexpr int placeDigits = 2;    // of km
constexpr int groundTexels = 512; // along the longer side

GriddedVolume VolumeOf(vtkImageData* image)
{
  constexpr int most = 2048; // of a texture, in browsers on Windows and on computers without a card
  if (image == nullptr || image->GetNumberOfPoints() == 0)
  {
    throw Error("the volume holds no voxels to draw");
  }
  const int* size = image->GetDimensions();
  if (std::max({size[0], size[1], size[2]}) > most)
  {
    throw Error("the volume of " + DimensionsText({size[0], size[1], size[2]}) +
                " voxels has more than the 2048 along an axis that browsers draw; merge it with "
                "fewer (--dims), or a part of it (--bounds)");
  }
  return vtkNexradImageToVolume(image);
}

Json MakeTheme(const scene::Theme& theme)
{
  const std::pair<const char*, const scene::Colour*> colours[] = {{"skyBottom", &theme.skyBottom},
    {"skyTop", &theme.skyTop}, {"ground", &theme.ground}, {"country", &theme.country},
    {"state", &theme.state}, {"county", &theme.county}, {"marker", &theme.marker},
    {"frame", &theme.frame}, {"wall", &theme.wall}, {"scale", &theme.scale},
    {"title", &theme.title}, {"note", &theme.note}, {"warning", &theme.warning},
    {"rim", &theme.rim}};
  Json json;
  for (const auto& [name, colour] : colours)
  {
    json[name] = *colour;
  }
  return json;
}

Json MakeLines(const std::vector<scene::GroundLine>& lines)
{
  Json json = Json::array();
  for (const scene::GroundLine& line : lines)
  {
    Json points = Json::array();
    for (const auto& [x, y] : line)
    {
      points.push_back(Rounded(x, placeDigits));
      points.push_back(Rounded(y, placeDigits));
    }
    json.push_back(std::move(points));
  }
  return json;
}

double Milliseconds(Time time)
{
  return std::round(1000.0 * ToSeconds(time));
}

// All radars of the times, each once.
std::vector<std::string> SitesOf(const std::vector<PageTime>& times)
{
  std::vector<std::string> sites;
  for (const PageTime& time : times)
  {
    for (const std::string& site : time.sites)
    {
      if (std::find(sites.begin(), sites.end(), site) == sites.end())
      {
        sites.push_back(site);
      }
    }
  }
  return sites;
}

PageCode MakeCode(const PagePresets& presets, const GriddedVolume& volume)
{
  if (volume.moment == MomentName::REF)
  {
    return PageCode::OfReflectivity(volume, LeastVisible(presets));
  }
  std::array<double, 2> range{};
  presets.all[presets.first].function->GetRange(range.data());
  return PageCode::OfRange(range);
}

} // namespace

PageScene::PageScene(const scene::DrawingRequest& webRequest, vtkImageData* image,
  const std::optional<scene::EchoExtent>& echo)
  : request(webRequest)
  , volume(VolumeOf(image))
{
  frame = scene::FrameVolume(image, scene::ReadVolumeInformation(image),
    echo ? echo : scene::MeasureEcho(image, request.scene), request.scene);
  box = frame.Bounds();
  framed = frame.Framed();
  for (std::array<double, 6>* each : {&box, &framed})
  {
    (*each)[4] /= frame.Exaggeration();
    (*each)[5] /= frame.Exaggeration();
  }
  array = ToString(volume.moment);
  presets = PresetsOf(request.scene, array);
  code = MakeCode(presets, volume);
  volume.values = {};
  volume.states = {};
  volume.further = {};
  this->MakeCamera(); // throws before work is done
  ground = scene::MakeGroundPicture(frame, scene::ThemeOf(request.scene.theme), groundTexels);
}

std::vector<std::uint8_t> PageScene::Encode(vtkImageData* image) const
{
  const GriddedVolume other = VolumeOf(image);
  if (other.grid != volume.grid || other.moment != volume.moment || other.fill != volume.fill)
  {
    throw Error("the volume of " + FormatIso8601(other.time) +
                " has another grid or moment than the first one; name volumes of one series");
  }
  return code.Encode(other);
}

Json PageScene::MakeMap() const
{
  auto lines = scene::PlaceMapLines(frame);
  if (!scene::ShowsCounties(frame))
  {
    lines[static_cast<std::size_t>(scene::MapLineKind::County)].clear();
  }
  return {{"country", MakeLines(lines[static_cast<std::size_t>(scene::MapLineKind::Country)])},
    {"state", MakeLines(lines[static_cast<std::size_t>(scene::MapLineKind::State)])},
    {"county", MakeLines(lines[static_cast<std::size_t>(scene::MapLineKind::County)])}};
}

std::vector<std::uint8_t> PageScene::GroundTexels() const
{
  constexpr int channels = 3;
  const auto* first = static_cast<const std::uint8_t*>(ground->GetScalarPointer());
  return {first, first + channels * ground->GetNumberOfPoints()};
}

Json PageScene::MakeRadars(const std::vector<PageTime>& times) const
{
  Json json = Json::array();
  for (const scene::PlacedSite& site : scene::PlaceSites(frame, SitesOf(times)))
  {
    if (site.within)
    {
      json.push_back({{"name", site.name},
        {"place", {Rounded(site.place[0], placeDigits), Rounded(site.place[1], placeDigits)}}});
      if (site.spread > 0.0)
      {
        json.back()["spread"] = Rounded(site.spread, placeDigits);
      }
    }
  }
  return json;
}

Json PageScene::MakeCamera() const
{
  const scene::CameraView& view = request.camera;
  Json json = {{"azimuth", view.azimuth}, {"tilt", view.tilt}, {"zoom", view.zoom},
    {"parallel", view.parallel}, {"lookAt", nullptr}};
  if (view.lookAt)
  {
    auto point = frame.ToScene(frame.PlaceOf(*view.lookAt));
    point[2] /= frame.Exaggeration();
    json["lookAt"] = point;
  }
  return json;
}

std::string PageScene::MakeText(const std::vector<PageTime>& times, const PageFiles& files) const
{
  const auto scale = scene::MomentScale(array, {});
  PageCode shownCode = code;
  if (!files.index.empty())
  {
    shownCode.floor.reset(); // volume files hold all echo
  }
  const Json offered = MakePresetsJson(presets, array, shownCode);
  const auto shown = std::find_if(offered.begin(), offered.end(),
    [&](const Json& preset) { return preset["name"] == presets.all[presets.first].name; });
  Json json = {{"title", scale.title}, {"unit", scale.unit}, {"array", array},
    {"method", volume.method}, {"sites", SitesOf(times)}, {"synthetic", volume.synthetic},
    {"masked", code.masked}, {"size", this->Size()}, {"box", box}, {"framed", framed},
    {"stretch", frame.Exaggeration()}, {"opacityDistance", frame.OpacityDistance()},
    {"camera", this->MakeCamera()}, {"theme", MakeTheme(scene::ThemeOf(request.scene.theme))},
    {"ground", {ground->GetDimensions()[0], ground->GetDimensions()[1]}}, {"map", this->MakeMap()},
    {"radars", this->MakeRadars(times)}, {"scale", {{"first", code.first}, {"step", code.step}}},
    {"floor", nullptr}, {"presets", offered}, {"preset", shown - offered.begin()},
    {"codes", code.bytes}, {"series", nullptr}, {"times", Json::array()},
    {"siteTexts", Json::array()}};
  if (shownCode.floor)
  {
    json["floor"] = *shownCode.floor;
  }
  if (!files.index.empty())
  {
    json["series"] = files.index;
    if (files.inBricks)
    {
      json["bricks"] = true;
    }
    return json.dump(-1, ' ', false, Json::error_handler_t::replace);
  }
  for (const PageTime& time : times)
  {
    json["times"].push_back(Milliseconds(time.time));
    json["siteTexts"].push_back(time.siteTexts);
  }
  return json.dump(-1, ' ', false, Json::error_handler_t::replace);
}

std::string PageScene::Title(const std::vector<PageTime>& times) const
{
  const std::string radars = scene::NameSites(SitesOf(times));
  return (volume.synthetic ? "SYNTHETIC: " : "") + scene::MomentScale(array, {}).title +
         (radars.empty() ? "" : " " + radars) + ", " +
         FormatIso8601(times.front().time).substr(0, 10);
}

PageTime CaptionsOf(vtkImageData* image, Time time, const scene::SceneOptions& options)
{
  scene::CaptionTexts texts;
  texts.information = scene::ReadVolumeInformation(image);
  const auto& sites = texts.information.sites;
  const std::string array = scene::ArrayOf(image);
  texts.ages = scene::AgesOfData(image, array, sites.size());
  const auto look = scene::MakeTransferFunction(options, array);
  const std::string nothing =
    scene::WordsForNothing(image, options.cut.box, look, texts.information.biologicalShare, false);
  if (!nothing.empty())
  {
    texts.information.notes.push_back(nothing);
  }
  return {time, sites, scene::SiteWords(texts)};
}

} // namespace nexrad::application

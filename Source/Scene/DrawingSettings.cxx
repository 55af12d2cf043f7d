// SPDX-License-Identifier: BSD-3-Clause
#include "Scene/DrawingSettings.h"

#include "nexrad/Geometry/Angles.h"
#include "nexrad/System/Error.h"
#include "vtkNexradTransferFunction.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <optional>
#include <set>

namespace nexrad::scene
{
namespace
{

using DrawingRow = Setting<DrawingOptions>;
using DrawingRows = SettingTable<DrawingOptions>;

constexpr char cameraGroup[] = "Camera";
constexpr char pictureGroup[] = "Picture";
constexpr char mapGroup[] = "Map in place of the volume";
constexpr char ofMapAlone[] = "is of --map; write --map composite as well";

// Types of values that drawing alone has.

ValueType<std::string> NameValue(const std::string& unit)
{
  const auto same = [](const std::string& text) { return text; };
  return {{"name", unit, {}}, same, same};
}

ValueType<std::string> PresetValue()
{
  std::set<std::string> names;
  std::string list;
  for (int i = 0; i < vtkNexradTransferFunction::GetNumberOfPresets(); ++i)
  {
    const std::string name = vtkNexradTransferFunction::GetPresetName(i);
    list += (list.empty() ? "{" : ",") + name;
    names.insert(name);
  }
  list += "}";
  const auto parse = [names, list](const std::string& text)
  { return text.empty() || names.count(text) > 0 ? text : throw Error(text + " not in " + list); };
  return {{"preset", "TEXT:" + list, {}}, parse, [](const std::string& name) { return name; }};
}

ValueType<std::filesystem::path> FileValue()
{
  const auto parse = [](const std::string& text)
  {
    if (!text.empty() && !std::filesystem::exists(text))
    {
      throw Error("File does not exist: " + text);
    }
    if (std::filesystem::is_directory(text))
    {
      throw Error("File is actually a directory: " + text);
    }
    return std::filesystem::path(text);
  };
  const auto write = [](const std::filesystem::path& path)
  { return path.empty() ? "" : std::filesystem::absolute(path).string(); };
  return {{"file", "FILE", {}}, parse, write};
}

// One entry of a list of iso-values: "35" or "35:0.5". Empty where it is none.
std::optional<IsoValue> ParseIsoValue(const std::string& text)
{
  const std::size_t colon = text.find(':');
  const std::vector<double> value = FindNumbers(text.substr(0, colon));
  const std::vector<double> opacity =
    colon == std::string::npos ? std::vector<double>{1.0} : FindNumbers(text.substr(colon + 1));
  if (value.size() != 1 || opacity.size() != 1 || opacity[0] <= 0.0 || opacity[0] > 1.0)
  {
    return std::nullopt;
  }
  IsoValue isoValue;
  isoValue.value = value[0];
  isoValue.opacity = colon == std::string::npos ? std::nullopt : std::optional(opacity[0]);
  return isoValue;
}

std::string IsoValuesText(const std::vector<IsoValue>& isoValues)
{
  std::string text;
  for (const IsoValue& isoValue : isoValues)
  {
    text += (text.empty() ? "" : ",") + NumberText(isoValue.value);
    text += isoValue.opacity ? ":" + NumberText(*isoValue.opacity) : "";
  }
  return text;
}

ValueType<std::vector<IsoValue>> IsoValuesValue()
{
  const auto parse = [](const std::string& text)
  { return text.empty() ? std::vector<IsoValue>() : ParseIsoValues(text); };
  return {{"iso-values", "VALUE[:OPACITY],...", {}}, parse, IsoValuesText};
}

ValueType<LightDirection> LightValue()
{
  const auto parse = [](const std::string& text) -> LightDirection
  {
    const std::vector<double> angles = FindNumbers(text);
    if (angles.size() != 2 || std::abs(angles[0]) > 360.0 || std::abs(angles[1]) > 90.0)
    {
      throw Error("'" + text +
                  "' is no direction of light; write degrees clockwise from north, -360 to 360, "
                  "and above the horizon, -90 to 90, as in 250,45");
    }
    return {angles[0], angles[1]};
  };
  const auto write = [](const LightDirection& from)
  { return NumberText(from.azimuth) + "," + NumberText(from.elevation); };
  return {{"direction", "AZIMUTH,ELEVATION", {}}, parse, write};
}

// "35.3,-97.3" or "35.3,-97.3,4km": latitude, longitude and height.
ValueType<LookAt> LookAtValue()
{
  const auto parse = [](const std::string& text) -> LookAt
  {
    const bool higher = SplitAtCommas(text).size() == 3;
    const std::size_t last = text.rfind(',');
    const std::vector<double> place = FindNumbers(higher ? text.substr(0, last) : text);
    if (place.size() != 2 || std::abs(place[0]) > 90.0 || std::abs(place[1]) > 360.0)
    {
      throw Error("'" + text +
                  "' is no place to look at; write latitude and longitude in degrees, and the "
                  "height above mean sea level if it is not 0, as in 35.3,-97.3,4km");
    }
    return {{place[1], place[0], higher ? ParseLength(text.substr(last + 1)) : 0.0}, true};
  };
  const auto write = [](const LookAt& lookAt)
  {
    const auto& [longitude, latitude, height] = lookAt.place;
    return !lookAt.geographic
             ? ""
             : NumberText(latitude) + "," + NumberText(longitude) + "," + LengthText(height);
  };
  return {{"place", "LATITUDE,LONGITUDE[,HEIGHT]", {}}, parse, write};
}

ValueType<double> RingsValue()
{
  return Where<double>(
    LengthValue(), [](double spacing) { return spacing == 0.0 || spacing >= 1000.0; },
    "is no distance of rings; write 1km or more, or 0 for none");
}

// In km of the scene.
ValueType<double> OpacityDistanceValue()
{
  const auto metres = Where<double>(
    LengthValue(), [](double length) { return length >= 1.0 && length <= 1e6; },
    "is no length of opacities; write 1m to 1000km, as in 5km");
  return {metres, [parse = metres.parse](const std::string& text) { return parse(text) / 1000.0; },
    [](double kilometres) { return LengthText(1000.0 * kilometres); }};
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

PlanOptions ParsePlan(const std::string& text)
{
  PlanOptions plan;
  if (text == "composite" || text == "lowest" || text == "vil")
  {
    plan.level = text == "lowest" ? PlanLevel::Lowest
                 : text == "vil"  ? PlanLevel::Liquid
                                  : PlanLevel::Composite;
    return plan;
  }
  if (ParseThresholdMap(text, "echo-top", plan.threshold))
  {
    plan.level = PlanLevel::EchoTop;
    return plan;
  }
  if (ParseThresholdMap(text, "vil-density", plan.threshold))
  {
    plan.level = PlanLevel::LiquidDensity;
    return plan;
  }
  try
  {
    plan.level = PlanLevel::Height;
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

std::string PlanText(const PlanOptions& plan)
{
  switch (plan.level)
  {
  case PlanLevel::Lowest:
    return "lowest";
  case PlanLevel::Height:
    return LengthText(plan.height);
  case PlanLevel::EchoTop:
    return "echo-top:" + NumberText(plan.threshold);
  case PlanLevel::Liquid:
    return "vil";
  case PlanLevel::LiquidDensity:
    return "vil-density:" + NumberText(plan.threshold);
  default:
    return "composite";
  }
}

// What is cut away. All places have one unit; a text replaces what was there.

std::string CropText(const CutOptions& cut)
{
  if (!cut.box)
  {
    return "";
  }
  const auto& [west, east, south, north, bottom, top] = *cut.box;
  return PlacesText(std::array{west, east, south, north}, cut.unit) + "," + LengthText(bottom) +
         "," + LengthText(top);
}

// A plane whose normal points along the azimuth, and upward by the elevation.
void TakeClipPlane(const std::string& text, CutOptions& cut)
{
  const std::vector<std::string> parts = SplitAtCommas(text);
  if (parts.size() != 3 && parts.size() != 5)
  {
    throw Error("'" + text +
                "' is no clip plane; write how far east and north it is, and the direction to what "
                "is drawn in degrees clockwise from north, as in -20km,0,90; of a plane that is "
                "not vertical also its height there, and how many degrees the direction points "
                "upward, as in -20km,0,90,5km,-30");
  }
  const bool vertical = parts.size() == 3;
  const double azimuth = RadiansPerDegree * ParseDegrees(parts[2]);
  const double elevation = vertical ? 0.0 : RadiansPerDegree * ParseDegrees(parts[4]);
  const double level = vertical ? 1.0 : std::cos(elevation);
  const std::array<double, 2> point = {
    ParsePlace(parts[0], cut.unit), ParsePlace(parts[1], cut.unit)};
  const double up = cut.unit == PlaceUnit::Degrees ? MetresPerDegree : 1.0;
  cut.plane = CutPlane{{point[0], point[1], vertical ? 0.0 : ParseLength(parts[3])},
    {level * std::sin(azimuth), level * std::cos(azimuth), std::sin(elevation) / up}};
}

// Of a direction that was computed from an angle with few digits.
std::string AngleText(double radians)
{
  constexpr double digits = 1e9;
  return NumberText(std::round(digits * radians / RadiansPerDegree) / digits);
}

std::string ClipText(const CutOptions& cut)
{
  if (!cut.plane)
  {
    return "";
  }
  const auto& [x, y, height] = cut.plane->origin;
  const auto& [east, north, up] = cut.plane->normal;
  const double metres = cut.unit == PlaceUnit::Degrees ? MetresPerDegree : 1.0;
  const std::string upright =
    PlacesText(std::array{x, y}, cut.unit) + "," + AngleText(std::atan2(east, north));
  return up == 0.0 ? upright
                   : upright + "," + LengthText(height) + "," +
                       AngleText(std::atan2(metres * up, std::hypot(east, north)));
}

void TakeSectionLine(const std::string& text, CutOptions& cut)
{
  const std::vector<std::string> parts = SplitAtCommas(text);
  if (parts.size() != 4)
  {
    throw Error("'" + text +
                "' is no line of a section; write how far east and north its ends A and B are, as "
                "in -20km,0,30km,15km");
  }
  SectionLine line;
  line.from = {ParsePlace(parts[0], cut.unit), ParsePlace(parts[1], cut.unit)};
  line.to = {ParsePlace(parts[2], cut.unit), ParsePlace(parts[3], cut.unit)};
  cut.section = line;
}

std::string SectionText(const CutOptions& cut)
{
  if (!cut.section)
  {
    return "";
  }
  const auto& [from, to] = *cut.section;
  return PlacesText(std::array{from[0], from[1], to[0], to[1]}, cut.unit);
}

// The rows, in the order of the help texts.

template <typename Value, typename Member>
DrawingRow MakeRow(const char* group, SettingUse use, const char* key, const char* says,
  const ValueType<Value>& type, Member member, const char* shown = "")
{
  return MakeSetting<DrawingOptions>({key, says, shown, "", use, group}, type, member);
}

// A row that is read into several members, or that depends on others.
DrawingRow MakeRow(const char* group, SettingUse use, const char* key, const char* says,
  ValueDescription value, std::function<void(DrawingOptions&, const std::string&)> set,
  std::function<std::string(const DrawingOptions&)> text)
{
  return MakeSetting<DrawingOptions>(
    {key, says, "", "", use, group}, std::move(value), std::move(set), std::move(text));
}

ValueType<std::size_t> TextureMemoryValue()
{
  const auto parse = [](const std::string& text)
  {
    constexpr std::size_t least = std::size_t(16) << 20;
    const std::size_t bytes = ParseMemory(text);
    if (bytes < least)
    {
      throw Error("'" + text + "' is too little for a volume; write 16MiB or more");
    }
    return bytes;
  };
  return {{"memory", "SIZE", {}}, parse, BytesText};
}

void AddCamera(DrawingRows& rows)
{
  constexpr SettingUse use = SettingUse::Result;
  rows.push_back(MakeRow(
    cameraGroup, use, "azimuth",
    "Where the camera stands, clockwise from north about the frame: 180 looks north",
    RealValue(-3600.0, 3600.0, "DEGREES"), [](auto& of) -> auto& { return of.camera.azimuth; }));
  rows.push_back(MakeRow(
    cameraGroup, use, "tilt", "Height of the camera above the horizon; 90 looks straight down",
    RealValue(-90.0, 90.0, "DEGREES"), [](auto& of) -> auto& { return of.camera.tilt; }));
  rows.push_back(MakeRow(
    cameraGroup, use, "zoom", "1 shows the whole frame, 2 half of its width",
    RealValue(0.01, 1000.0, "FACTOR"), [](auto& of) -> auto& { return of.camera.zoom; }));
  rows.push_back(MakeRow(
    cameraGroup, use, "look-at",
    "What is in the middle of the picture, as in 35.3,-97.3,4km (default: the frame fills the "
    "picture)",
    Optional(LookAtValue()), [](auto& of) -> auto& { return of.camera.lookAt; }));
  rows.push_back(MakeRow(
    cameraGroup, use, "parallel", "Parallel in place of perspective projection", FlagValue(),
    [](auto& of) -> auto& { return of.camera.parallel; }));
}

void AddSlices(DrawingRows& rows)
{
  constexpr SettingUse use = SettingUse::Picture;
  rows.push_back(MakeRow(
    pictureGroup, use, "look",
    "usual; or classic, the look of earlier versions: a dark, unlit scene about the whole domain, "
    "8 times as high, with 256 slices. Other options change what it sets",
    ChoiceValue<bool>("look", {{"usual", false}, {"classic", true}}),
    [](DrawingOptions& of, const std::string& text)
    {
      if (ChoiceValue<bool>("look", {{"usual", false}, {"classic", true}}).parse(text))
      {
        UseClassicLook(of.scene);
      }
    },
    [](const DrawingOptions&) { return std::string(); }));
  rows.push_back(MakeRow(
    pictureGroup, SettingUse::Program, "size", "Width and height in pixels", PictureSizeValue(),
    [](auto& of) -> auto& { return of.size; }));
  rows.push_back(MakeRow(
    pictureGroup, use, "mapper", "texture-slice, or ray-cast: VTK's, for comparison",
    ChoiceValue<MapperChoice>("mapper",
      {{"texture-slice", MapperChoice::TextureSlice}, {"ray-cast", MapperChoice::RayCast}}),
    [](auto& of) -> auto& { return of.scene.mapper; }));
  rows.push_back(MakeRow(
    pictureGroup, use, "classification",
    "How a slice finds its colours: pre-integrated, from all scalars between its front and its "
    "back; or sampled, from one scalar, as VTK's ray caster does",
    ChoiceValue<bool>("classification", {{"pre-integrated", true}, {"sampled", false}}),
    [](auto& of) -> auto& { return of.scene.preIntegration; }));
  rows.push_back(MakeRow(
    pictureGroup, use, "interpolation",
    "Between voxels: linear; or nearest, which shows each voxel as a box of one value",
    ChoiceValue<bool>("interpolation", {{"linear", true}, {"nearest", false}}),
    [](auto& of) -> auto& { return of.scene.linearInterpolation; }));
  rows.push_back(MakeRow(
    pictureGroup, use, "slices",
    "Slices, or samples along the longest ray, up to 16384; 0: about three for every eight voxels "
    "along the view",
    NumberValue(0, 16384), [](auto& of) -> auto& { return of.scene.slices; }));
  rows.push_back(MakeRow(
    pictureGroup, use, "texture-memory",
    "Memory of the graphics card that the voxels of a volume may take, MiB or GiB: of volumes in "
    "several sizes of voxels the smallest that fit are drawn",
    TextureMemoryValue(), [](auto& of) -> auto& { return of.scene.textureMemory; }));
}

void AddAppearance(DrawingRows& rows)
{
  constexpr SettingUse use = SettingUse::Result;
  rows.push_back(MakeRow(
    pictureGroup, use, "exaggeration",
    "How much heights are stretched, 0.1 to 100; the picture states it (default: by the size of "
    "the frame, 3 for what one radar sees, up to 8 for many radars)",
    Optional(
      RealValue(0.1, 100.0, "FACTOR", "is no factor of heights; write a number from 0.1 to 100")),
    [](auto& of) -> auto& { return of.scene.exaggeration; }));
  rows.push_back(MakeRow(
    pictureGroup, use, "frame",
    "What fills the picture: echo, with the radars near it, at all times of a movie; or domain",
    ChoiceValue<FrameChoice>(
      "frame", {{"echo", FrameChoice::Echo}, {"domain", FrameChoice::Domain}}, "WHAT"),
    [](auto& of) -> auto& { return of.scene.framing; }));
  rows.push_back(MakeRow(
    pictureGroup, use, "preset",
    "Colours and opacities: six of REF, then one of each other moment (default: the first of the "
    "moment)",
    PresetValue(), [](auto& of) -> auto& { return of.scene.preset; }));
  rows.push_back(MakeRow(
    pictureGroup, use, "iso-values",
    "Draw the surfaces of these values in the unit of the moment, as m/s, whatever unit the colour "
    "bar has, with the colours of the preset, as in 20:0.3,40:0.6,50:1; usual opacities: from 0.35 "
    "for the lowest to 0.95 for the highest",
    IsoValuesValue(), [](auto& of) -> auto& { return of.scene.isoValues; }));
  rows.back().refusal = [](const DrawingOptions& of)
  { return of.scene.plan ? "are of a volume; a map has no surfaces" : ""; };
  rows.push_back(MakeRow(
    pictureGroup, use, "colours",
    "Colours in place of the preset's, and opacities if the file has any (with --colour-by, those "
    "of its moment, without opacities): ParaView's .json, a .pal table, or .csv with a heading, "
    "then lines dBZ,#rrggbb",
    FileValue(), [](auto& of) -> auto& { return of.scene.colours; }));
  rows.push_back(MakeRow(
    pictureGroup, use, "opacities",
    "Opacities alone, in place of those of the preset and of --colours: such a file; with "
    "--colour-by, of the moment that is shown",
    FileValue(), [](auto& of) -> auto& { return of.scene.opacities; }));
  rows.push_back(MakeRow(
    pictureGroup, use, "opacity-distance",
    "The length along a ray to which opacities belong (default: so that the echo is seen neither "
    "faint nor solid)",
    Optional(OpacityDistanceValue()), [](auto& of) -> auto& { return of.scene.opacityDistance; }));
  rows.push_back(MakeRow(
    pictureGroup, use, "theme",
    "light: dark letters over a pale ground; dark: light letters over a grey one",
    ChoiceValue<ThemeChoice>("theme", {{"dark", ThemeChoice::Dark}, {"light", ThemeChoice::Light}}),
    [](auto& of) -> auto& { return of.scene.theme; }));
}

void AddLight(DrawingRows& rows)
{
  constexpr SettingUse use = SettingUse::Picture;
  rows.push_back(MakeRow(
    pictureGroup, use, "colour-by",
    "Colours from another array than the moment, which then gives the opacities alone: a moment, "
    "as VEL, or an ancillary array, as REF_age, REF_radars, REF_weight or REF_site. Brown: no "
    "value",
    NameValue("ARRAY"), [](auto& of) -> auto& { return of.scene.colourBy; }));
  rows.back().refusal = [](const DrawingOptions& of)
  { return of.scene.plan ? "is of a volume; --array is what a map shows" : ""; };
  rows.push_back(MakeRow(
    pictureGroup, use, "shadow",
    "How dark the shadows are that the volume casts on itself and on the ground; 0: none",
    RealValue(0.0, 1.0, "STRENGTH"), [](auto& of) -> auto& { return of.scene.light.shadow; }));
  rows.push_back(MakeRow(
    pictureGroup, use, "occlusion",
    "How dark the volume and the ground are where they see little of the sky; 0: no effect",
    RealValue(0.0, 1.0, "STRENGTH"), [](auto& of) -> auto& { return of.scene.light.occlusion; }));
  rows.push_back(MakeRow(
    pictureGroup, use, "light",
    "Where the light of the shadows comes from, degrees clockwise from north and above the horizon "
    "of the stretched scene",
    LightValue(), [](auto& of) -> auto& { return of.scene.light.direction; }));
}

void AddSurroundings(DrawingRows& rows)
{
  constexpr SettingUse use = SettingUse::Picture;
  rows.push_back(MakeRow(
    pictureGroup, use, "rings",
    "Rings of range about each radar at multiples of this, m or km; 0: none", RingsValue(),
    [](auto& of) -> auto& { return of.scene.ringSpacing; }, "0"));
  rows.push_back(MakeRow(
    pictureGroup, use, "walls", "No lines of equal height on the walls behind the volume",
    FlagValue(), [](auto& of) -> auto& { return of.scene.heightWalls; }));
  rows.push_back(MakeRow(
    pictureGroup, use, "names", "Names of states and provinces on the map", FlagValue(),
    [](auto& of) -> auto& { return of.scene.placeNames; }));
}

DrawingRow MakeCutRow(const char* key, const char* unit, const char* says,
  void (*take)(const std::string&, CutOptions&), std::string (*write)(const CutOptions&),
  void (*leave)(CutOptions&))
{
  const auto set = [take, leave](DrawingOptions& of, const std::string& text)
  {
    CutOptions cut = of.scene.cut;
    leave(cut);
    const bool none = !cut.box && !cut.plane && !cut.section;
    cut.unit = none ? PlaceUnit::OfVolume : cut.unit;
    if (!text.empty())
    {
      take(text, cut);
    }
    of.scene.cut = cut;
  };
  return MakeRow(pictureGroup, SettingUse::Picture, key, says, {"places", unit, {}}, set,
    [write](const DrawingOptions& of) { return write(of.scene.cut); });
}

void AddCuts(DrawingRows& rows)
{
  rows.push_back(MakeCutRow(
    "crop", "WEST,EAST,SOUTH,NORTH,BOTTOM,TOP",
    "Draw the part of the volume within this box alone, m or km east and north of the domain's "
    "centre and above mean sea level; of a volume on axes of longitude and latitude, west to north "
    "in degrees, as in -98deg,-97deg,35deg,36deg,0,15km",
    [](const std::string& text, CutOptions& cut) { cut.box = ParseBoxWithHeights(text, cut.unit); },
    CropText, [](CutOptions& cut) { cut.box.reset(); }));
  rows.push_back(MakeCutRow("clip", "EAST,NORTH,AZIMUTH[,HEIGHT,ELEVATION]",
    "Draw the part of the volume on one side of a plane alone: a point of it, m or km east and "
    "north of the domain's centre (or longitude and latitude, as in -97.5deg,35deg), and the "
    "direction to that part, degrees clockwise from north; without HEIGHT (of the point) and "
    "ELEVATION (of the direction, degrees), the plane is vertical",
    TakeClipPlane, ClipText, [](CutOptions& cut) { cut.plane.reset(); }));
  rows.push_back(MakeCutRow("section", "EAST,NORTH,EAST,NORTH",
    "Draw the line of a vertical section on the ground: its ends A and B, m or km east and north "
    "of the domain's centre, or longitude and latitude, as in -98deg,35deg,-97deg,35.5deg",
    TakeSectionLine, SectionText, [](CutOptions& cut) { cut.section.reset(); }));
}

void AddMap(DrawingRows& rows)
{
  rows.push_back(MakeRow(
    mapGroup, SettingUse::Picture, "map",
    "Of each column the largest value (composite; of VEL the fastest), the lowest that was scanned "
    "(lowest), the one at a height above mean sea level, m or km, the height of the echo top at 18 "
    "dBZ or another threshold (echo-top, echo-top:30), the vertically integrated liquid (vil), or "
    "the liquid through the height of the echo top (vil-density, vil-density:30); seen from above, "
    "north up",
    {"map", "WHICH", {}},
    [](DrawingOptions& of, const std::string& text)
    {
      std::optional<PlanOptions>& plan = of.scene.plan;
      const std::string array = plan ? plan->array : "";
      plan = text.empty() ? std::nullopt : std::optional(ParsePlan(text));
      if (plan)
      {
        plan->array = array;
      }
    },
    [](const DrawingOptions& of) { return of.scene.plan ? PlanText(*of.scene.plan) : ""; }));
  rows.push_back(MakeRow(
    mapGroup, SettingUse::Picture, "array",
    "With --map: what is drawn, as REF_age, REF_radars, REF_weight or REF_site (default: the "
    "moment)",
    {"name", "NAME", {}},
    [](DrawingOptions& of, const std::string& text)
    { of.scene.plan ? of.scene.plan->array = text : throw Error(ofMapAlone); },
    [](const DrawingOptions& of) { return of.scene.plan ? of.scene.plan->array : ""; }));
  rows.push_back(MakeRow(
    mapGroup, SettingUse::Program, "perspective",
    "With --map: perspective in place of parallel projection", FlagValue(),
    [](DrawingOptions& of, const std::string& text)
    { of.camera.parallel = !FlagValue().parse(text); },
    [](const DrawingOptions& of) { return of.scene.plan && !of.camera.parallel ? "on" : "off"; }));
  rows.back().excludes = "parallel";
  rows.back().refusal = [](const DrawingOptions& of) { return of.scene.plan ? "" : ofMapAlone; };
}

} // namespace

std::vector<IsoValue> ParseIsoValues(const std::string& text)
{
  constexpr char right[] = "; write values, each with the opacity of its surface above 0 and up to "
                           "1 if it is not to have the usual one, as in 20:0.3,40:0.6,50:1";
  std::vector<IsoValue> isoValues;
  for (const std::string& entry : SplitAtCommas(text))
  {
    const std::optional<IsoValue> isoValue = ParseIsoValue(entry);
    if (!isoValue)
    {
      throw Error("'" + entry + "' in '" + text + "' is no iso-value" + right);
    }
    const bool twice = std::any_of(isoValues.begin(), isoValues.end(),
      [&](const IsoValue& other) { return other.value == isoValue->value; });
    if (twice)
    {
      throw Error("'" + text + "' has the value of '" + entry + "' twice" + right);
    }
    isoValues.push_back(*isoValue);
  }
  return isoValues;
}

DrawingOptions UsualBeside(const DrawingOptions& options)
{
  DrawingOptions usual;
  if (options.scene.plan)
  {
    usual.camera.azimuth = 180.0;
    usual.camera.tilt = 90.0;
    usual.camera.parallel = true;
  }
  return usual;
}

const SettingTable<DrawingOptions>& DrawingSettings()
{
  static const DrawingRows table = []
  {
    DrawingRows rows;
    AddCamera(rows);
    AddSlices(rows);
    AddAppearance(rows);
    AddLight(rows);
    AddSurroundings(rows);
    AddCuts(rows);
    AddMap(rows);
    return rows;
  }();
  return table;
}

} // namespace nexrad::scene

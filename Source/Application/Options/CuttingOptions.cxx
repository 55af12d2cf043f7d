// SPDX-License-Identifier: BSD-3-Clause
#include "Options/CuttingOptions.h"

#include "Options/UnitOptions.h"
#include "nexrad/System/Error.h"

#include <CLI/CLI.hpp>

#include <array>
#include <cmath>
#include <locale>
#include <sstream>
#include <string>
#include <string_view>
#include <vector>

namespace nexrad::application
{
namespace
{

std::vector<std::string> SplitAtCommas(const std::string& text)
{
  std::vector<std::string> parts;
  std::istringstream list(text + ',');
  for (std::string part; std::getline(list, part, ',');)
  {
    parts.push_back(part);
  }
  return parts;
}

// Degrees, -360 to 360. `whole`: what the user wrote.
double ParseNumber(const std::string& text, const std::string& whole)
{
  std::istringstream stream(text);
  stream.imbue(std::locale::classic());
  double angle = 0.0;
  stream >> angle;
  if (stream.fail() || stream.peek() != std::istringstream::traits_type::eof() ||
      !(std::abs(angle) <= 360.0))
  {
    throw Error("'" + whole + "' is no angle; write degrees, -360 to 360");
  }
  return angle;
}

// In radians.
double ParseAngle(const std::string& text)
{
  constexpr double degree = 3.14159265358979323846 / 180.0;
  return degree * ParseNumber(text, text);
}

// Without its unit, which all cuts have in common: "20km" and "500m" in m, "-97.5deg" in degrees.
double TakeCoordinate(const std::string& text, scene::CutOptions& cut)
{
  constexpr std::string_view ending = "deg";
  const bool degrees = text.size() > ending.size() &&
                       text.compare(text.size() - ending.size(), ending.size(), ending) == 0;
  const std::string number = text.substr(0, text.size() - ending.size());
  const double coordinate = degrees ? ParseNumber(number, text) : ParseLength(text);
  const scene::CutUnit unit = degrees ? scene::CutUnit::Degrees : scene::CutUnit::Metres;
  if (text == "0")
  {
    return coordinate;
  }
  if (cut.unit != scene::CutUnit::OfVolume && cut.unit != unit)
  {
    throw Error("'" + text +
                "': some places of the cuts are in degrees and some in m or km; write all of them "
                "in degrees for a volume on axes of longitude and latitude, else in m or km");
  }
  cut.unit = unit;
  return coordinate;
}

void TakeCropBox(const std::string& text, scene::CutOptions& cut)
{
  const std::vector<std::string> parts = SplitAtCommas(text);
  std::array<double, 6> box{};
  if (parts.size() != box.size())
  {
    throw Error("'" + text +
                "' is no crop box; write its west, east, south, north, bottom and top with units, "
                "as in -50km,20km,-40km,60km,0,15km or -98deg,-97deg,35deg,36deg,0,15km");
  }
  for (std::size_t i = 0; i < box.size(); ++i)
  {
    box[i] = i < 4 ? TakeCoordinate(parts[i], cut) : ParseLength(parts[i]);
    if (i % 2 == 1 && !(box[i] > box[i - 1]))
    {
      throw Error("'" + text + "' is no crop box: " + parts[i] + " is not above " + parts[i - 1]);
    }
  }
  cut.box = box;
}

// A plane whose normal points along the azimuth, and upward by the elevation.
void TakeClipPlane(const std::string& text, scene::CutOptions& cut)
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
  const double azimuth = ParseAngle(parts[2]);
  const double elevation = vertical ? 0.0 : ParseAngle(parts[4]);
  const double level = vertical ? 1.0 : std::cos(elevation);
  const std::array<double, 2> point = {
    TakeCoordinate(parts[0], cut), TakeCoordinate(parts[1], cut)};
  const double up = cut.unit == scene::CutUnit::Degrees ? scene::MetresPerDegree : 1.0;
  cut.plane = scene::CutPlane{{point[0], point[1], vertical ? 0.0 : ParseLength(parts[3])},
    {level * std::sin(azimuth), level * std::cos(azimuth), std::sin(elevation) / up}};
}

void TakeSectionLine(const std::string& text, scene::CutOptions& cut)
{
  const std::vector<std::string> parts = SplitAtCommas(text);
  if (parts.size() != 4)
  {
    throw Error("'" + text +
                "' is no line of a section; write how far east and north its ends A and B are, as "
                "in -20km,0,30km,15km");
  }
  SectionLine line;
  line.from = {TakeCoordinate(parts[0], cut), TakeCoordinate(parts[1], cut)};
  line.to = {TakeCoordinate(parts[2], cut), TakeCoordinate(parts[3], cut)};
  cut.section = line;
}

// An option whose text `take` puts into `cut`.
void AddCut(CLI::App& command, const std::string& name, scene::CutOptions& cut,
  void (*take)(const std::string&, scene::CutOptions&), const char* unit, const char* description)
{
  const auto store = [&cut, take, name](const std::string& text)
  {
    try
    {
      take(text, cut);
    }
    catch (const Error& error)
    {
      throw CLI::ValidationError(name, error.what());
    }
  };
  command.add_option_function<std::string>(name, store, description)
    ->type_name(unit)
    ->expected(1)
    ->group("Picture");
}

} // namespace

void AddCuttingOptions(CLI::App& command, scene::CutOptions& cut)
{
  AddCut(command, "--crop", cut, TakeCropBox, "WEST,EAST,SOUTH,NORTH,BOTTOM,TOP",
    "Draw the part of the volume within this box alone, m or km east and north of the domain's "
    "centre and above mean sea level; of a volume on axes of longitude and latitude, west to north "
    "in degrees, as in -98deg,-97deg,35deg,36deg,0,15km");
  AddCut(command, "--clip", cut, TakeClipPlane, "EAST,NORTH,AZIMUTH[,HEIGHT,ELEVATION]",
    "Draw the part of the volume on one side of a plane alone: a point of it, m or km east and "
    "north of the domain's centre (or longitude and latitude, as in -97.5deg,35deg), and the "
    "direction to that part, degrees clockwise from north; without HEIGHT (of the point) and "
    "ELEVATION (of the direction, degrees), the plane is vertical");
  AddCut(command, "--section", cut, TakeSectionLine, "EAST,NORTH,EAST,NORTH",
    "Draw the line of a vertical section on the ground: its ends A and B, m or km east and north "
    "of the domain's centre, or longitude and latitude, as in -98deg,35deg,-97deg,35.5deg");
}

} // namespace nexrad::application

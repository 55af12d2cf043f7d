// SPDX-License-Identifier: BSD-3-Clause
#include "Options/CuttingOptions.h"

#include "Options/UnitOptions.h"
#include "nexrad/Geometry/Angles.h"
#include "nexrad/System/Error.h"

#include <CLI/CLI.hpp>

#include <array>
#include <cmath>
#include <string>
#include <vector>

namespace nexrad::application
{
namespace
{

// In radians.
double ParseAngle(const std::string& text)
{
  return RadiansPerDegree * ParseDegrees(text);
}

void TakeCropBox(const std::string& text, scene::CutOptions& cut)
{
  cut.box = ParseBoxWithHeights(text, cut.unit);
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
    ParsePlace(parts[0], cut.unit), ParsePlace(parts[1], cut.unit)};
  const double up = cut.unit == PlaceUnit::Degrees ? MetresPerDegree : 1.0;
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
  line.from = {ParsePlace(parts[0], cut.unit), ParsePlace(parts[1], cut.unit)};
  line.to = {ParsePlace(parts[2], cut.unit), ParsePlace(parts[3], cut.unit)};
  cut.section = line;
}

// An option whose text `take` puts into `cut`.
void AddCut(CLI::App& command, const std::string& name, scene::CutOptions& cut,
  void (*take)(const std::string&, scene::CutOptions&), const char* unit, const char* description)
{
  AddTextOption(
    command, name, [&cut, take](const std::string& text) { take(text, cut); }, unit, description)
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

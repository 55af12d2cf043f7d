// SPDX-License-Identifier: BSD-3-Clause
#include "Options/CuttingOptions.h"

#include "Options/UnitOptions.h"
#include "nexrad/System/Error.h"

#include <CLI/CLI.hpp>

#include <array>
#include <cmath>
#include <locale>
#include <optional>
#include <sstream>
#include <string>
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

std::optional<std::array<double, 6>> ParseCropBox(const std::string& text)
{
  const std::vector<std::string> parts = SplitAtCommas(text);
  std::array<double, 6> box{};
  if (parts.size() != box.size())
  {
    throw Error("'" + text +
                "' is no crop box; write its west, east, south, north, bottom and top with units, "
                "as in -50km,20km,-40km,60km,0,15km");
  }
  for (std::size_t i = 0; i < box.size(); ++i)
  {
    box[i] = ParseLength(parts[i]);
    if (i % 2 == 1 && !(box[i] > box[i - 1]))
    {
      throw Error("'" + text + "' is no crop box: " + parts[i] + " is not above " + parts[i - 1]);
    }
  }
  return box;
}

// In radians.
double ParseAngle(const std::string& text)
{
  constexpr double degree = 3.14159265358979323846 / 180.0;
  std::istringstream stream(text);
  stream.imbue(std::locale::classic());
  double angle = 0.0;
  stream >> angle;
  if (stream.fail() || stream.peek() != std::istringstream::traits_type::eof() ||
      !(std::abs(angle) <= 360.0))
  {
    throw Error("'" + text + "' is no angle; write degrees, -360 to 360");
  }
  return degree * angle;
}

// A plane whose normal points along the azimuth, and upward by the elevation.
std::optional<scene::CutPlane> ParseClipPlane(const std::string& text)
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
  return scene::CutPlane{
    {ParseLength(parts[0]), ParseLength(parts[1]), vertical ? 0.0 : ParseLength(parts[3])},
    {level * std::sin(azimuth), level * std::cos(azimuth), std::sin(elevation)}};
}

std::optional<SectionLine> ParseSectionLine(const std::string& text)
{
  const std::vector<std::string> parts = SplitAtCommas(text);
  if (parts.size() != 4)
  {
    throw Error("'" + text +
                "' is no line of a section; write how far east and north its ends A and B are, as "
                "in -20km,0,30km,15km");
  }
  return SectionLine{
    {ParseLength(parts[0]), ParseLength(parts[1])}, {ParseLength(parts[2]), ParseLength(parts[3])}};
}

} // namespace

void AddCuttingOptions(CLI::App& command, scene::CutOptions& cut)
{
  constexpr char group[] = "Picture";
  AddParsedOption(command, "--crop", cut.box, ParseCropBox, "WEST,EAST,SOUTH,NORTH,BOTTOM,TOP",
    "Draw the part of the volume within this box alone, m or km east and north of the domain's "
    "centre and above mean sea level")
    ->group(group);
  AddParsedOption(command, "--clip", cut.plane, ParseClipPlane,
    "EAST,NORTH,AZIMUTH[,HEIGHT,ELEVATION]",
    "Draw the part of the volume on one side of a plane alone: a point of it, m or km east and "
    "north of the domain's centre, and the direction to that part, degrees clockwise from north; "
    "without HEIGHT (of the point) and ELEVATION (of the direction, degrees), the plane is "
    "vertical")
    ->group(group);
  AddParsedOption(command, "--section", cut.section, ParseSectionLine, "EAST,NORTH,EAST,NORTH",
    "Draw the line of a vertical section on the ground: its ends A and B, m or km east and north "
    "of the domain's centre")
    ->group(group);
}

} // namespace nexrad::application

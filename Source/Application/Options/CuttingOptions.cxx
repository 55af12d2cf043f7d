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

double ParseAzimuth(const std::string& text)
{
  std::istringstream stream(text);
  stream.imbue(std::locale::classic());
  double azimuth = 0.0;
  stream >> azimuth;
  if (stream.fail() || stream.peek() != std::istringstream::traits_type::eof() ||
      !(std::abs(azimuth) <= 360.0))
  {
    throw Error("'" + text + "' is no direction; write degrees clockwise from north, -360 to 360");
  }
  return azimuth;
}

// A vertical plane; its normal points along the azimuth.
std::optional<scene::CutPlane> ParseClipPlane(const std::string& text)
{
  constexpr double degree = 3.14159265358979323846 / 180.0;
  const std::vector<std::string> parts = SplitAtCommas(text);
  if (parts.size() != 3)
  {
    throw Error("'" + text +
                "' is no clip plane; write how far east and north it is, and the direction to what "
                "is drawn in degrees clockwise from north, as in -20km,0,90");
  }
  const double azimuth = degree * ParseAzimuth(parts[2]);
  return scene::CutPlane{{ParseLength(parts[0]), ParseLength(parts[1]), 0.0},
    {std::sin(azimuth), std::cos(azimuth), 0.0}};
}

} // namespace

void AddCuttingOptions(CLI::App& command, scene::CutOptions& cut)
{
  constexpr char group[] = "Picture";
  AddParsedOption(command, "--crop", cut.box, ParseCropBox, "WEST,EAST,SOUTH,NORTH,BOTTOM,TOP",
    "Draw the part of the volume within this box alone, m or km east and north of the domain's "
    "centre and above mean sea level")
    ->group(group);
  AddParsedOption(command, "--clip", cut.plane, ParseClipPlane, "EAST,NORTH,AZIMUTH",
    "Draw the part of the volume on one side of a vertical plane alone: a point of it, m or km "
    "east and north of the domain's centre, and the direction to that part, degrees clockwise from "
    "north")
    ->group(group);
}

} // namespace nexrad::application

// SPDX-License-Identifier: BSD-3-Clause
#include "Options/BoxOptions.h"

#include "Options/UnitOptions.h"

#include <CLI/CLI.hpp>

#include <optional>
#include <string>

namespace nexrad::application
{
namespace
{

BoxRequest& BoxOf(InputRequest& request)
{
  return request.box ? *request.box : request.box.emplace();
}

} // namespace

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
    "Merge this box of the domain again in voxels of 250 m (larger where it is wider than 60 km) "
    "and draw it in place of that part of the volume: m or km east and north of the domain's "
    "centre; of a domain on axes of longitude and latitude degrees, as in "
    "-98deg,-97deg,35deg,36deg. From radar files alone");
  faces->group(group);
  AddTextOption(command, "--follow-from", takeTime, "TIME",
    "The box is there at this time, in UTC; before and after, it has moved with the echo in it")
    ->needs(faces)
    ->group(group);
}

} // namespace nexrad::application

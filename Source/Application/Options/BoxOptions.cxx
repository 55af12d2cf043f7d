// SPDX-License-Identifier: BSD-3-Clause
#include "Options/BoxOptions.h"

#include "Options/UnitOptions.h"
#include "nexrad/System/Error.h"

#include <CLI/CLI.hpp>

#include <array>
#include <functional>
#include <locale>
#include <sstream>
#include <vector>

namespace nexrad::application
{
namespace
{

// m of a length with its unit, or a bare number: degrees, on geographic axes.
double ParsePlace(const std::string& text)
{
  std::istringstream stream(text);
  stream.imbue(std::locale::classic());
  double degrees = 0.0;
  stream >> degrees;
  const bool bare = !stream.fail() && stream.peek() == std::istringstream::traits_type::eof();
  return bare ? degrees : ParseLength(text);
}

std::array<double, 4> ParseFaces(const std::string& text)
{
  std::vector<std::string> parts;
  std::istringstream list(text + ',');
  for (std::string part; std::getline(list, part, ',');)
  {
    parts.push_back(part);
  }
  std::array<double, 4> faces{};
  if (parts.size() != faces.size())
  {
    throw Error("'" + text +
                "' is no box; write its west, east, south and north with units, as in "
                "-50km,10km,-40km,20km, or on geographic axes in degrees");
  }
  for (std::size_t i = 0; i < faces.size(); ++i)
  {
    faces[i] = ParsePlace(parts[i]);
    if (i % 2 == 1 && !(faces[i] > faces[i - 1]))
    {
      throw Error("'" + text + "' is no box: " + parts[i] + " is not above " + parts[i - 1]);
    }
  }
  return faces;
}

CLI::Option* AddPart(CLI::App& command, const std::string& name, const std::string& unit,
  const std::string& description, const std::function<void(const std::string&)>& store)
{
  const auto checked = [name, store](const std::string& text)
  {
    try
    {
      store(text);
    }
    catch (const Error& error)
    {
      throw CLI::ValidationError(name, error.what());
    }
  };
  return command.add_option_function<std::string>(name, checked, description)
    ->type_name(unit)
    ->expected(1)
    ->group("Box in finer voxels");
}

} // namespace

void AddBoxOptions(CLI::App& command, std::optional<BoxRequest>& box)
{
  const auto boxToFill = [&box]() -> BoxRequest&
  {
    box = box ? box : BoxRequest();
    return *box;
  };
  CLI::Option* faces = AddPart(command, "--box", "WEST,EAST,SOUTH,NORTH",
    "Merge this box of the domain again in voxels of 250 m (larger where it is wider than 60 km) "
    "and draw it in place of that part of the volume: m or km east and north of the domain's "
    "centre, on geographic axes degrees. From radar files alone",
    [boxToFill](const std::string& text) { boxToFill().faces = ParseFaces(text); });
  AddPart(command, "--follow-from", "TIME",
    "The box is there at this time, in UTC; before and after, it has moved with the echo in it",
    [boxToFill](const std::string& text) { boxToFill().followedFrom = ParseTime(text); })
    ->needs(faces);
}

} // namespace nexrad::application

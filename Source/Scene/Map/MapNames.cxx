// SPDX-License-Identifier: BSD-3-Clause
#include "Scene/Map/MapNames.h"

#include "nexrad/System/Error.h"

#include <cstddef>
#include <locale>
#include <sstream>

namespace nexrad::embedded
{
extern const unsigned char mapNames[];
extern const std::size_t mapNamesSize;
extern const unsigned char mapTowns[];
extern const std::size_t mapTownsSize;
} // namespace nexrad::embedded

namespace nexrad::scene
{

std::vector<MapName> ParseMapNames(const std::string& text)
{
  std::vector<MapName> names;
  std::istringstream lines(text);
  std::string line;
  std::getline(lines, line); // the heading
  for (int number = 2; std::getline(lines, line); ++number)
  {
    MapName name;
    const std::size_t comma = line.find(',');
    name.name = line.substr(0, comma);
    std::istringstream place(comma == std::string::npos ? "" : line.substr(comma + 1));
    place.imbue(std::locale::classic());
    char separator = '\0';
    place >> name.longitude >> separator >> name.latitude;
    if (!place || name.name.empty() || separator != ',' || !(place >> std::ws).eof())
    {
      throw Error("map names: line " + std::to_string(number) + ": '" + line +
                  "' must hold a name, a longitude and a latitude");
    }
    names.push_back(name);
  }
  return names;
}

const std::vector<MapName>& EmbeddedMapNames()
{
  static const std::vector<MapName> names =
    ParseMapNames(std::string(embedded::mapNames, embedded::mapNames + embedded::mapNamesSize));
  return names;
}

const std::vector<MapName>& EmbeddedTowns()
{
  static const std::vector<MapName> towns =
    ParseMapNames(std::string(embedded::mapTowns, embedded::mapTowns + embedded::mapTownsSize));
  return towns;
}

} // namespace nexrad::scene

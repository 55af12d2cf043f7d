// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

namespace nexrad::scene
{

/// A name on the map.
struct MapName
{
  std::string name;
  double longitude = 0.0; ///< degrees
  double latitude = 0.0;
};

/// Reads lines "name,longitude,latitude" below a heading. Throws Error, naming the line, for one
/// that is none.
std::vector<MapName> ParseMapNames(const std::string& text);

/// The names that are compiled in (Data/map_names.csv): states and territories of the United States
/// and provinces of Canada, each at a point far from its borders.
const std::vector<MapName>& EmbeddedMapNames();

/// The towns that are compiled in (Data/map_towns.csv): those within 8° of each radar, the largest
/// first.
const std::vector<MapName>& EmbeddedTowns();

} // namespace nexrad::scene

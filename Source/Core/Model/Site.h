// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>

namespace nexrad
{

/// A point on WGS84 with a height.
struct Position
{
  double latitude = 0.0;  ///< degrees, north positive
  double longitude = 0.0; ///< degrees, east positive
  double altitude = 0.0;  ///< m above mean sea level; of the antenna, for a radar

  bool operator==(const Position& other) const
  {
    return latitude == other.latitude && longitude == other.longitude && altitude == other.altitude;
  }
};

/// A radar. Name and position are unknown when neither the file nor the site table has them.
struct Site
{
  std::string name; ///< ICAO identifier of four letters, "" when unknown
  std::optional<Position> position;
};

} // namespace nexrad

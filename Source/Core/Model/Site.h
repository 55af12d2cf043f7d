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

/// Tells radars apart: by their names; those without a name by where they stand. A radar whose
/// stored position differs a little between two of its files is one radar all the same
/// (StandApart).
struct SiteKey
{
  std::string name;       ///< empty when the files give none
  double latitude = 0.0;  ///< degrees; 0 for a radar with a name, or without a position
  double longitude = 0.0; ///< degrees; likewise

  bool operator==(const SiteKey& other) const;
  bool operator<(const SiteKey& other) const;
};

/// The key of a radar.
SiteKey KeyOf(const Site& site);

/// True when two radars of one name stand more than 2 km from each other, so that they are two, or
/// the position of one is wrong. Positions of one radar in the test data, and those of the site
/// table, differ by less than 50 m. False where a position is unknown.
bool StandApart(const Site& a, const Site& b);

} // namespace nexrad

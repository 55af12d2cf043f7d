// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "nexrad/Model/Site.h"

#include <string>
#include <string_view>
#include <vector>

namespace nexrad
{

/// A row of Data/radar_sites.csv (see Data/README.md for its origin).
struct KnownSite
{
  std::string name;      ///< ICAO identifier
  std::string place;     ///< "Kansas City"
  std::string state;     ///< "MO"
  bool terminal = false; ///< a Terminal Doppler Weather Radar
  Position position;     ///< altitude is the antenna's, m above mean sea level
  double ground = 0.0;   ///< m above mean sea level, of the ground at the radar
};

/// The rows of a table, in the order of their names. Throws Error, with the number of the line, for
/// a row that has no name or no position, or a position that is not on Earth.
std::vector<KnownSite> ParseSiteTable(const std::string& text);

/// All radars that the program knows, in the order of their names.
const std::vector<KnownSite>& KnownSites();

/// The radar of that identifier, or nullptr.
const KnownSite* FindSite(std::string_view name);

/// Whether a radar is a Terminal Doppler Weather Radar: the table says so of its name.
bool IsTerminal(const Site& site);

/// Width of a radar's beam between half-power points, degrees: 0.55 of a terminal radar, else 0.95
/// (Formulas B4).
double BeamWidthOf(const Site& site);

} // namespace nexrad

// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Model/Site.h"

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
};

/// All radars that the program knows, in the order of their names.
const std::vector<KnownSite>& KnownSites();

/// The radar of that identifier, or nullptr.
const KnownSite* FindSite(std::string_view name);

} // namespace nexrad

// SPDX-License-Identifier: BSD-3-Clause
#include "nexrad/Model/SiteTable.h"

#include "nexrad/System/Embedded.h"

#include <algorithm>
#include <sstream>

namespace nexrad
{

namespace
{

// Columns: icao, kind, name, state, latitude_deg, longitude_deg, ground_m_msl, antenna_m_msl.
KnownSite ParseRow(const std::string& line)
{
  std::vector<std::string> cells;
  std::istringstream row(line);
  for (std::string cell; std::getline(row, cell, ',');)
  {
    cells.push_back(cell);
  }
  cells.resize(8);
  const std::string& altitude = cells.at(7).empty() ? cells.at(6) : cells.at(7);
  return {cells.at(0), cells.at(2), cells.at(3), cells.at(1) == "tdwr",
    {std::stod(cells.at(4)), std::stod(cells.at(5)), std::stod(altitude)}};
}

bool ByName(const KnownSite& first, const KnownSite& second)
{
  return first.name < second.name;
}

std::vector<KnownSite> ParseTable()
{
  std::istringstream table(
    std::string(embedded::radarSites, embedded::radarSites + embedded::radarSitesSize));
  std::vector<KnownSite> sites;
  std::string line;
  std::getline(table, line);
  while (std::getline(table, line))
  {
    sites.push_back(ParseRow(line));
  }
  std::sort(sites.begin(), sites.end(), ByName);
  return sites;
}

} // namespace

const std::vector<KnownSite>& KnownSites()
{
  static const std::vector<KnownSite> sites = ParseTable();
  return sites;
}

const KnownSite* FindSite(std::string_view name)
{
  const std::vector<KnownSite>& sites = KnownSites();
  const auto found = std::lower_bound(sites.begin(), sites.end(), name,
    [](const KnownSite& site, std::string_view wanted) { return site.name < wanted; });
  return found != sites.end() && found->name == name ? &*found : nullptr;
}

bool IsTerminal(const Site& site)
{
  const KnownSite* known = FindSite(site.name);
  return known != nullptr && known->terminal;
}

double BeamWidthOf(const Site& site)
{
  constexpr double terminalWidth = 0.55;
  constexpr double usualWidth = 0.95;
  return IsTerminal(site) ? terminalWidth : usualWidth;
}

} // namespace nexrad

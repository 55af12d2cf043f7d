// SPDX-License-Identifier: BSD-3-Clause
#include "nexrad/Model/SiteTable.h"

#include "nexrad/System/Error.h"

#include <algorithm>
#include <charconv>
#include <cstddef>
#include <sstream>

// Data/radar_sites.csv, which is compiled in (CMake/NexradEmbed.cmake).
namespace nexrad::embedded
{

extern const unsigned char radarSites[];
extern const std::size_t radarSitesSize;

} // namespace nexrad::embedded

namespace nexrad
{

namespace
{

// The whole cell as a number within the limits. No locale has a say in it.
double NumberOf(const std::string& cell, double least, double most)
{
  double number = 0.0;
  const char* const end = cell.data() + cell.size();
  const auto read = std::from_chars(cell.data(), end, number);
  if (read.ec != std::errc() || read.ptr != end || !(number >= least && number <= most))
  {
    throw Error("\"" + cell.substr(0, 80) + "\" must be a number from " + std::to_string(least) +
                " to " + std::to_string(most));
  }
  return number;
}

// Columns: icao, kind, name, state, latitude_deg, longitude_deg, ground_m_msl, antenna_m_msl.
KnownSite ParseRow(const std::string& line)
{
  constexpr double lowest = -500.0; // m; the shore of the Dead Sea lies at -430
  constexpr double highest = 9'000.0;
  std::vector<std::string> cells;
  std::istringstream row(line);
  for (std::string cell; std::getline(row, cell, ',');)
  {
    cells.push_back(cell);
  }
  cells.resize(8);
  if (cells[0].empty())
  {
    throw Error("the radar has no name");
  }
  const std::string& altitude = cells[7].empty() ? cells[6] : cells[7];
  const std::string& ground = cells[6].empty() ? cells[7] : cells[6];
  return {cells[0], cells[2], cells[3], cells[1] == "tdwr",
    {NumberOf(cells[4], -90.0, 90.0), NumberOf(cells[5], -180.0, 180.0),
      NumberOf(altitude, lowest, highest)},
    NumberOf(ground, lowest, highest)};
}

} // namespace

std::vector<KnownSite> ParseSiteTable(const std::string& text)
{
  std::istringstream table(text);
  std::vector<KnownSite> sites;
  std::string line;
  std::getline(table, line); // the heading
  for (int number = 2; std::getline(table, line); ++number)
  {
    try
    {
      sites.push_back(ParseRow(line));
    }
    catch (const Error& problem)
    {
      throw Error("line " + std::to_string(number) + " of the site table: " + problem.what());
    }
  }
  std::sort(sites.begin(), sites.end(),
    [](const KnownSite& first, const KnownSite& second) { return first.name < second.name; });
  return sites;
}

const std::vector<KnownSite>& KnownSites()
{
  static const std::vector<KnownSite> sites = ParseSiteTable(
    std::string(embedded::radarSites, embedded::radarSites + embedded::radarSitesSize));
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

// SPDX-License-Identifier: BSD-3-Clause
#include "Commands/WindReport.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <ostream>

namespace nexrad::application
{

namespace
{

using Json = nlohmann::ordered_json;

// Files and tables need no more digits than the fit has.
double Rounded(double value)
{
  return std::round(value * 100.0) / 100.0;
}

double PercentOf(std::size_t part, std::size_t whole)
{
  return whole == 0 ? 0.0 : 100.0 * static_cast<double>(part) / static_cast<double>(whole);
}

} // namespace

nlohmann::ordered_json MakeWindJson(const WindReport& report)
{
  const bool placed = report.site.position.has_value();
  const double altitude = placed ? report.site.position->altitude : 0.0;
  Json result = {{"file", report.file},
    {"site", report.site.name.empty() ? Json(nullptr) : Json(report.site.name)},
    {"antenna_altitude_m", placed ? Json(altitude) : Json(nullptr)},
    {"start", FormatIso8601(report.start)}, {"end", FormatIso8601(report.end)},
    {"synthetic", report.synthetic}, {"velocities", report.counts.measured},
    {"unfolded", report.counts.unfolded}, {"unknown", report.counts.unknown},
    {"levels", Json::array()}};
  for (const ProfileLevel& level : report.profile.levels)
  {
    result["levels"].push_back(
      {{"height_m", placed ? Json(level.height + altitude) : Json(nullptr)},
        {"height_above_antenna_m", level.height}, {"speed_m_s", Rounded(level.wind.Speed())},
        {"direction_deg", Rounded(level.wind.Direction())}, {"east_m_s", Rounded(level.wind.east)},
        {"north_m_s", Rounded(level.wind.north)}, {"rms_m_s", Rounded(level.rms)},
        {"gates", level.gates}});
  }
  return result;
}

void PrintWindTable(const WindReport& report, std::ostream& out)
{
  const bool placed = report.site.position.has_value();
  const double altitude = placed ? report.site.position->altitude : 0.0;
  out << report.file << (report.synthetic ? " (SYNTHETIC)\n" : "\n") << "  "
      << (report.site.name.empty() ? "unnamed site" : report.site.name) << ", "
      << FormatIso8601(report.start) << " to " << FormatIso8601(report.end) << '\n'
      << std::fixed << std::setprecision(2) << "  " << report.counts.measured << " velocities, "
      << PercentOf(report.counts.unfolded, report.counts.measured) << " % unfolded, "
      << PercentOf(report.counts.unknown, report.counts.measured) << " % unknown\n";
  if (report.profile.levels.empty())
  {
    out << "  no wind profile: at no height velocities fit one wind in half of the directions\n";
    return;
  }
  out << (placed ? "  m above sea" : "m above radar") << "   m/s  from degrees  rms m/s    gates\n";
  for (auto level = report.profile.levels.rbegin(); level != report.profile.levels.rend(); ++level)
  {
    out << std::setprecision(0) << std::setw(13) << level->height + altitude << std::setprecision(1)
        << std::setw(6) << level->wind.Speed() << std::setprecision(0) << std::setw(14)
        << level->wind.Direction() << std::setprecision(1) << std::setw(9) << level->rms
        << std::setw(9) << level->gates << '\n';
  }
}

} // namespace nexrad::application

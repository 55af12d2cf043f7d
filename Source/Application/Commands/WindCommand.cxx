// SPDX-License-Identifier: BSD-3-Clause
#include "Commands/CommandLine.h"

#include "Output/ExplainedRead.h"
#include "Output/MessageOutput.h"
#include "nexrad/System/RangeLoop.h"
#include "nexrad/Velocity/Dealiasing.h"
#include "nexrad/Velocity/WindProfile.h"

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include <cmath>
#include <iomanip>
#include <iostream>
#include <memory>
#include <optional>
#include <ostream>
#include <string>
#include <vector>

namespace nexrad::application
{
namespace
{

/// The wind profile of one volume, and how it was dealiased.
struct WindReport
{
  std::string file;
  Site site;
  Time start{};
  Time end{};
  bool synthetic = false;
  DealiasCounts counts;
  WindProfile profile;
};

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

/// What `wind --json` prints of one volume: Documentation/Formats/wind.md has the schema.
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

/// The same for people: three lines on the volume, and a table of its levels, the highest first.
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

struct WindOptions
{
  std::vector<std::string> files;
  double layer = 300.0;
  double range = 60.0;
  bool json = false;
};

// Makes one report after the other; the profile of a volume helps to dealias the next of its site.
class WindReporter
{
public:
  explicit WindReporter(const WindOptions& theOptions)
  {
    profileOptions.layerDepth = theOptions.layer;
    profileOptions.farthest = 1000.0 * theOptions.range;
    dealiasOptions.loop = ThreadLoop(CoreCount());
  }

  // Empty where the volume has no velocity.
  std::optional<WindReport> Report(const RadarVolume& volume)
  {
    constexpr Duration oldest = std::chrono::minutes(30);
    const PolarVolume measured = MakePolarVolume(volume, MomentName::VEL);
    VelocityVolume velocities = MakeVelocityVolume(measured);
    if (velocities.sweeps.empty())
    {
      return std::nullopt;
    }
    const bool follows = last && last->site.name == volume.site.name &&
                         measured.start >= last->start && measured.start - last->end < oldest;
    dealiasOptions.before = follows ? last->profile : WindProfile();
    WindReport report{volume.file, volume.site, measured.start, measured.end, volume.synthetic,
      Dealias(velocities, dealiasOptions), {}};
    report.profile = FitWindProfile(velocities, profileOptions);
    last = report;
    return report;
  }

private:
  ProfileOptions profileOptions;
  DealiasOptions dealiasOptions;
  std::optional<WindReport> last;
};

int RunWind(const WindOptions& options)
{
  WindReporter reporter(options);
  nlohmann::ordered_json result = nlohmann::ordered_json::array();
  bool anyRay = false;
  bool anyDamage = false;
  const std::vector<InputSubject> subjects = FindSubjects(options.files, anyDamage);
  ExplainedReader reader(subjects);
  for (const auto& [file, ofFolder] : subjects)
  {
    const RadarVolume volume = reader.Next();
    anyDamage = anyDamage || !volume.damage.empty();
    if (HoldsMetadataAlone(volume))
    {
      PrintMessage(file + ": metadata alone, no ray: passed over");
      continue;
    }
    for (const RadarVolume& cycle : SplitCycles(volume))
    {
      const std::optional<WindReport> report = reporter.Report(cycle);
      if (!report)
      {
        if (!volume.sweeps.empty()) // else reading it said what is wrong
        {
          PrintMessage(file + ": no ray has velocities; a wind profile needs the moment VEL");
        }
        anyDamage = true;
        continue;
      }
      anyRay = true;
      options.json ? result.push_back(MakeWindJson(*report)) : PrintWindTable(*report, std::cout);
    }
  }
  if (options.json)
  {
    PrintJson(result);
  }
  return !anyRay ? Failed : anyDamage ? DoneWithDamage : Done;
}

} // namespace

void AddWindCommand(CLI::App& program, CommandAction& action)
{
  const auto options = std::make_shared<WindOptions>();
  CLI::App* command = program.add_subcommand("wind",
    "Prints the wind profile over the radar for each volume: the velocity-azimuth display of "
    "dealiased velocities");
  command
    ->add_option("FILE", options->files,
      "Level II files, folders of real-time chunks, or folders and tar archives of files")
    ->required();
  command->add_flag("--json", options->json,
    "print JSON: metres, metres a second, degrees, UTC (default: a table)");
  command
    ->add_option("--layer", options->layer, "depth of the layer of each level, m (default: 300)")
    ->check(CLI::Range(50.0, 5000.0));
  command
    ->add_option("--range", options->range,
      "ground distance up to which velocities are used, km (default: 60)")
    ->check(CLI::Range(5.0, 300.0));
  command->callback([options, &action] { action = [options] { return RunWind(*options); }; });
}

} // namespace nexrad::application

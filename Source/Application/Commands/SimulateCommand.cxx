// SPDX-License-Identifier: BSD-3-Clause
#include "Commands/CommandLine.h"

#include "Commands/SimulatedFiles.h"
#include "Options/UnitOptions.h"
#include "Output/MessageOutput.h"
#include "Output/ProgressBar.h"
#include "nexrad/Calibration/RadarBiases.h"
#include "nexrad/Model/SiteTable.h"
#include "nexrad/System/Error.h"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <iostream>
#include <memory>
#include <optional>
#include <string>

namespace nexrad::application
{
namespace
{

constexpr double wholeDay = 24.0; // hours

struct SimulateCommandOptions
{
  std::string folder;
  SimulatedDayOptions day;
  std::optional<Time> begin;
  double hours = wholeDay;
  std::vector<SimulatedSite> sites = SimulatedDayOptions::DefaultSites();
  std::optional<int> coveragePattern;
  RadarBiases biases;
  bool quiet = false;
};

std::string JoinNumbers(const std::vector<int>& numbers)
{
  std::string text;
  for (const int number : numbers)
  {
    text += (text.empty() ? "" : ", ") + std::to_string(number);
  }
  return text;
}

int ParsePattern(const std::string& text)
{
  for (const int number : KnownCoveragePatterns())
  {
    if (text == std::to_string(number))
    {
      return number;
    }
  }
  throw Error("'" + text + "' is no coverage pattern that can be simulated; those are " +
              JoinNumbers(KnownCoveragePatterns()));
}

// The pattern that a site scans when the user names none: that of the default day, or 21.
int UsualPattern(const std::string& name)
{
  constexpr int otherwise = 21;
  for (const SimulatedSite& site : SimulatedDayOptions::DefaultSites())
  {
    if (site.name == name)
    {
      return site.coveragePattern;
    }
  }
  return otherwise;
}

// "KLSX" or "KLSX:212".
SimulatedSite ParseSite(const std::string& text)
{
  const std::size_t colon = text.find(':');
  const std::string name = text.substr(0, colon);
  if (!FindSite(name))
  {
    throw Error("site '" + name + "' is unknown; write names of the site table, as in KLSX");
  }
  return {
    name, colon == std::string::npos ? UsualPattern(name) : ParsePattern(text.substr(colon + 1))};
}

// "KEAX,KILX:12,KLSX".
std::vector<SimulatedSite> ParseSites(const std::string& text)
{
  std::vector<SimulatedSite> sites;
  for (const std::string& part : SplitAtCommas(text))
  {
    const SimulatedSite site = ParseSite(part);
    for (const SimulatedSite& other : sites)
    {
      if (other.name == site.name)
      {
        throw Error("site " + site.name + " is named twice; a site scans one pattern");
      }
    }
    sites.push_back(site);
  }
  return sites;
}

void SetBiases(const RadarBiases& biases, std::vector<SimulatedSite>& sites)
{
  for (const auto& [name, bias] : biases)
  {
    const auto site = std::find_if(sites.begin(), sites.end(),
      [&wanted = name](const SimulatedSite& each) { return each.name == wanted; });
    if (site == sites.end())
    {
      throw CLI::ValidationError(
        "--bias", "site '" + name + "' is not simulated; name radars of --sites");
    }
    site->bias = bias;
  }
}

SimulatedDayOptions ResolveDay(const SimulateCommandOptions& options)
{
  SimulatedDayOptions day = options.day;
  const Time midnight = *ParseIso8601("2006-03-12");
  constexpr auto busiest = std::chrono::hours(18);
  day.begin = options.begin.value_or(options.hours < wholeDay ? midnight + busiest : midnight);
  day.length = Duration(static_cast<std::int64_t>(options.hours * 3'600'000.0));
  day.sites = options.sites;
  for (SimulatedSite& site : day.sites)
  {
    site.coveragePattern = options.coveragePattern.value_or(site.coveragePattern);
  }
  SetBiases(options.biases, day.sites);
  if (day.dualPolarisation && day.messageType != 31)
  {
    throw CLI::ValidationError(
      "--dual-polarisation", "message 1 has no such moments; add --message-type 31");
  }
  return day;
}

void Print(
  const std::string& folder, const SimulatedDayOptions& day, const SimulationReport& report)
{
  std::cout << folder << ": SYNTHETIC storm day, " << Counted(report.files.size(), "file") << ", "
            << Counted(report.bytes, "byte") << ", " << FormatIso8601(report.begin) << " to "
            << FormatIso8601(report.end) << '\n';
  for (const SimulatedSite& site : day.sites)
  {
    std::cout << "  " << site.name << " VCP " << site.coveragePattern << ", message "
              << day.messageType << ", a volume every "
              << ToSeconds(Time(VolumePeriod(site.coveragePattern))) << " s\n";
  }
}

int RunSimulate(const SimulateCommandOptions& options, const SimulatedDayOptions& day)
{
  WatchStopSignals();
  ProgressBar bar("simulating", options.quiet);
  const SimulationReport report = WriteSimulatedFiles(
    day, options.folder, [&bar](double fraction) { return bar.Update(fraction); });
  bar.Clear();
  if (!options.quiet)
  {
    Print(options.folder, day, report);
  }
  if (report.files.empty())
  {
    throw Error("no volume begins in the " + std::to_string(options.hours) +
                " hours asked for; ask for more");
  }
  return Done;
}

} // namespace

void AddSimulateCommand(CLI::App& program, CommandAction& action)
{
  const auto options = std::make_shared<SimulateCommandOptions>();
  CLI::App* command = program.add_subcommand("simulate",
    "Write a synthetic storm day over Missouri and Illinois as Level II files of several radars");
  command->add_option("folder", options->folder, "Folder that takes the files; made when missing")
    ->required()
    ->type_name("DIR");
  AddParsedOption(*command, "--begin", options->begin, ParseTime, "TIME",
    "Begin of the period, UTC; by default 2006-03-12T00:00, or 18:00 when it is shorter than a "
    "day");
  command->add_option("--hours", options->hours, "Length of the period in hours")
    ->type_name("HOURS")
    ->check(CLI::Range(0.01, 24.0 * 366.0))
    ->capture_default_str();
  AddParsedOption(*command, "--sites", options->sites, ParseSites, "NAME[:VCP],…",
    "Radars, and the coverage pattern that each scans", "KEAX:21,KILX:12,KLSX:11");
  AddParsedOption(*command, "--vcp", options->coveragePattern, ParsePattern, "NUMBER",
    "Coverage pattern of all radars: one of " + JoinNumbers(KnownCoveragePatterns()));
  command
    ->add_option("--message-type", options->day.messageType,
      "1: gates of 1 km and 250 m, rays of 1 degree; 31: super-resolution, 250 m, half a degree")
    ->type_name("1|31")
    ->check(CLI::IsMember({1, 31}))
    ->capture_default_str();
  AddParsedOption(*command, "--not-weather", options->day.notWeather, ParseEchoKinds, "KIND[,…]",
    "Echo that is not weather, added to the storms: clutter (fixed targets near the radar and on "
    "ridges), propagation (ground that bent beams meet far away), biological (a bloom of insects "
    "and birds), sun and interference (spikes), test-pattern (rays of one value), speckle (single "
    "gates), or all",
    "none");
  AddParsedOption(*command, "--bias", options->biases, ParseBiases, "NAME:DB[,…]",
    "How many dB too high each of these radars measures reflectivity", "0 dB");
  command->add_flag("--dual-polarisation", options->day.dualPolarisation,
    "Write the moments ZDR, PHI and RHO too; needs --message-type 31");
  const auto containers = ChoiceValue<Level2Container>(
    "container", {{"bare", Level2Container::Bare}, {"gzip", Level2Container::Gzip},
                   {"ldm", Level2Container::LdmBzip2}});
  AddValueOption(*command, "--container", options->day.container, containers,
    "bare: messages as they are; gzip: the same, compressed; ldm: bzip2 records");
  command->add_option("--seed", options->day.seed, "Seed of the storms and of the noise")
    ->type_name("NUMBER")
    ->capture_default_str();
  command
    ->add_option("--refraction", options->day.effectiveRadiusFactor,
      "Effective earth radius of the simulated air, in radii (4/3: standard)")
    ->type_name("FACTOR")
    ->check(CLI::Range(0.5, 5.0))
    ->default_str("1.3333");
  AddQuietOption(*command, options->quiet);
  command->callback([options, &action]
    { action = [options, day = ResolveDay(*options)] { return RunSimulate(*options, day); }; });
}

} // namespace nexrad::application

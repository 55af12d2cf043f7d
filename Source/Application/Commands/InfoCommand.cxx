// SPDX-License-Identifier: BSD-3-Clause
#include "Commands/CommandLine.h"

#include "Commands/InfoReport.h"
#include "Options/UnitOptions.h"
#include "Output/BiasOutput.h"
#include "Output/ExplainedRead.h"
#include "Output/MessageOutput.h"
#include "nexrad/Model/SiteTable.h"

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <iostream>
#include <iterator>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace nexrad::application
{

namespace
{

struct InfoOptions
{
  std::vector<std::string> files;
  InfoRequest request;
  std::string site;
  std::optional<Position> position;
  bool json = false;
};

GateRequest ParseGate(const std::string& text)
{
  unsigned sweep = 0;
  unsigned ray = 0;
  unsigned gate = 0;
  int used = 0;
  const bool digits = text.find_first_not_of("0123456789,") == std::string::npos;
  if (!digits || std::sscanf(text.c_str(), "%5u,%5u,%5u%n", &sweep, &ray, &gate, &used) != 3 ||
      used != static_cast<int>(text.size()))
  {
    throw Error("'" + text + "' is no SWEEP,RAY,GATE, for example 0,12,345");
  }
  return {sweep, ray, gate};
}

Position ParsePosition(const std::string& text)
{
  Position place;
  int used = 0;
  if (std::sscanf(text.c_str(), "%lf,%lf,%lf%n", &place.latitude, &place.longitude, &place.altitude,
        &used) != 3 ||
      used != static_cast<int>(text.size()) || !(std::abs(place.latitude) <= 90.0) ||
      !(std::abs(place.longitude) <= 180.0) || !(std::abs(place.altitude) < 10'000.0))
  {
    throw Error("'" + text +
                "' is no LATITUDE,LONGITUDE,ALTITUDE in degrees and metres, for example "
                "38.70,-90.68,219");
  }
  return place;
}

// Names each request that a file cannot answer; true when there was one.
bool NameMissingGates(const RadarVolume& volume, const std::vector<GateRequest>& requests)
{
  bool missing = false;
  for (const GateRequest& request : requests)
  {
    if (!volume.sweeps.empty() && FindRay(volume, request) == nullptr)
    {
      PrintMessage("nexrad3d info: --gate " + std::to_string(request.sweep) + ',' +
                   std::to_string(request.ray) + ',' + std::to_string(request.gate) + ": " +
                   volume.file + " has no such ray; it has " +
                   Counted(volume.sweeps.size(), "sweep") + ", counted from 0");
      missing = true;
    }
  }
  return missing;
}

// What is said of the files so far.
struct InfoOutput
{
  nlohmann::ordered_json report = nlohmann::ordered_json::array();
  LowEchoes echoes;    // where there are several files
  bool anyUse = false; // some file has rays, or the metadata that it should have
  bool anyDamage = false;
  bool missingGates = false;
};

// Says what is in the files, and fills the rest of the output.
void ReadSubjects(const InfoOptions& options, const Level2Options& readOptions, InfoOutput& output)
{
  const InfoRequest& request = options.request;
  const std::vector<InputSubject> subjects = FindSubjects(options.files, output.anyDamage);
  ExplainedReader reader(subjects, readOptions);
  for (const InputSubject& subject : subjects)
  {
    const RadarVolume volume = reader.Next();
    output.anyUse = output.anyUse || !volume.sweeps.empty() || HoldsMetadataAlone(volume);
    output.anyDamage = output.anyDamage || !volume.damage.empty();
    output.missingGates = NameMissingGates(volume, request.gates) || output.missingGates;
    if (subjects.size() > 1)
    {
      AddLowEchoes(volume, output.echoes);
    }
    if (options.json)
    {
      output.report.push_back(MakeInfoJson(volume, request));
    }
    else if (subject.ofFolder && !request.echo && request.gates.empty())
    {
      PrintInfoLine(volume, std::cout);
    }
    else
    {
      PrintInfoTable(volume, request, std::cout);
    }
  }
}

int RunInfo(const InfoOptions& options)
{
  Level2Options readOptions;
  readOptions.siteName = options.site;
  readOptions.position = options.position;
  if (!options.site.empty() && FindSite(options.site) == nullptr && !readOptions.position)
  {
    PrintMessage("nexrad3d info: --site: unknown site '" + options.site +
                 "'; give a site of the table, such as KLSX, or its --position too");
    return WrongUsage;
  }
  InfoOutput output;
  ReadSubjects(options, readOptions, output);
  const BiasReport comparison = CompareRadars(output.echoes);
  if (options.json)
  {
    for (nlohmann::ordered_json& file : output.report)
    {
      if (!comparison.IsEmpty() && file["site"].is_string())
      {
        AddBiasOf(file["site"], comparison, file);
      }
    }
    PrintJson(output.report);
  }
  else
  {
    PrintBiases(comparison, {}, std::cout);
  }
  return !output.anyUse        ? Failed
         : output.missingGates ? WrongUsage
         : output.anyDamage    ? DoneWithDamage
                               : Done;
}

} // namespace

void AddInfoCommand(CLI::App& program, CommandAction& action)
{
  const auto options = std::make_shared<InfoOptions>();
  CLI::App* command = program.add_subcommand("info",
    "Says what is in Level II files: site, position, VCP, times, sweeps, moments, gates, damage");
  command
    ->add_option("FILE", options->files,
      "Level II files, folders of real-time chunks, or folders and tar archives of files: a line "
      "for "
      "each file")
    ->required();
  command->add_flag("--json", options->json,
    "print JSON: metres, degrees, metres a second, UTC (default: a table)");
  command->add_flag("--echo", options->request.echo,
    "count what quality control finds in the reflectivity: echo of weather, and of what else");
  const auto takeGates = [options](const std::vector<std::string>& texts)
  {
    try
    {
      std::transform(
        texts.begin(), texts.end(), std::back_inserter(options->request.gates), ParseGate);
    }
    catch (const Error& error)
    {
      throw CLI::ValidationError("--gate", error.what());
    }
  };
  command
    ->add_option_function<std::vector<std::string>>("--gate", takeGates,
      "SWEEP,RAY,GATE, each counted from 0: print what this gate holds; may be given many times")
    ->allow_extra_args(false);
  command->add_option("--site", options->site,
    "name of the radar, in place of the one in the files (default: from the file, else from its "
    "name)");
  AddParsedOption(*command, "--position", options->position, ParsePosition, "TEXT",
    "LATITUDE,LONGITUDE,ALTITUDE of the antenna, degrees and metres above mean sea level "
    "(default: from the file, else from the site table)");
  command->callback([options, &action] { action = [options] { return RunInfo(*options); }; });
}

} // namespace nexrad::application

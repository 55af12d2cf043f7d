// SPDX-License-Identifier: BSD-3-Clause
#include "BenchCommandLine.h"

#include "BenchComparison.h"
#include "BenchSheets.h"
#include "BenchTables.h"
#include "Options/DrawingOptions.h"
#include "Options/GridOptions.h"
#include "Options/UnitOptions.h"
#include "Output/ProgressBar.h"
#include "Tables/ThesisFigures.h"
#include "nexrad/Merging/TimeMerge.h"
#include "nexrad/System/Error.h"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <iterator>
#include <memory>

namespace nexrad::application
{
namespace
{

MergeMethod ParseMethod(const std::string& text)
{
  const auto method = ParseMergeMethod(text);
  if (!method)
  {
    throw Error("'" + text + "' is no method of merging; nexrad3d grid --help names them");
  }
  return *method;
}

void AddInputs(CLI::App& command, BenchOptions& options)
{
  command
    .add_option("input", options.inputs,
      "Radar files, or folders of them (default: a synthetic series is simulated)")
    ->type_name("INPUT");
  command
    .add_option("--hours", options.hours,
      "Length of the synthetic series in hours; from 18:00 UTC on, a whole day from midnight")
    ->type_name("HOURS")
    ->check(CLI::Range(0.25, 24.0))
    ->capture_default_str();
}

void AddDimensions(CLI::App& command, BenchRequest& request)
{
  const auto addDimensions = [&request](const std::string& text)
  {
    try
    {
      request.dimensions.push_back(ParseDimensions(text));
    }
    catch (const Error& error)
    {
      throw CLI::ValidationError("--dims", error.what());
    }
  };
  command
    .add_option_function<std::vector<std::string>>(
      "--dims",
      [addDimensions](const std::vector<std::string>& texts)
      { std::for_each(texts.begin(), texts.end(), addDimensions); },
      "Voxels of the merged volumes; may be given many times (default: the thesis's three)")
    ->allow_extra_args(false)
    ->type_name("XxYxZ");
}

void AddOptions(CLI::App& command, BenchOptions& options)
{
  AddInputs(command, options);
  command
    .add_option("--runs", options.request.runs,
      "How often everything is measured; frames are seen from as many sides")
    ->type_name("NUMBER")
    ->check(CLI::Range(1, 1000))
    ->capture_default_str();
  AddDimensions(command, options.request);
  AddParsedOption(command, "--method", options.request.options.method, ParseMethod, "NAME",
    "How rays become voxels", ToString(options.request.options.method));
  AddParsedOption(command, "--quality", options.request.options.quality.level, ParseQuality, "NAME",
    "What quality control takes out of REF: off, standard or strict; of the method beam",
    "standard");
  AddParsedOption(command, "--max-gap", options.request.options.maximumGap, ParseDuration,
    "DURATION", "A site's volume farther than this from a time does not count", "15min");
  command
    .add_option("--only", options.only,
      "These tables alone, as in grid,drawing (default: decode,grid,series,drawing); with --sheets "
      "these sheets (default: resolution,slices,times,sweeps)")
    ->delimiter(',')
    ->allow_extra_args(false)
    ->type_name("NAMES");
  command.add_flag("--json", options.json, "Print JSON, units in the names (default: tables)");
  AddQuietOption(command, options.quiet);
  command
    .add_option("--compare", options.compare,
      "Measure nothing: set two files that --json wrote side by side, on two machines perhaps")
    ->expected(2)
    ->type_name("A B");
}

void AddSheets(CLI::App& command, scene::SheetRequest& request)
{
  constexpr char group[] = "Sheets of pictures in place of the tables";
  command
    .add_option("--sheets", request.folder,
      "Draw the thesis's experiments into this folder: a sheet NAME.png and its numbers, NAME.json")
    ->type_name("FOLDER")
    ->group(group);
  AddParsedOption(command, "--time", request.time, ParseTime, "TIME",
    "What is drawn, in UTC (default: the middle of the files; the sheet of times has its own)")
    ->group(group);
  AddParsedOption(command, "--size", request.size, ParsePictureSize, "WxH",
    "Width and height of each picture of a sheet in pixels", "796x532")
    ->group(group);
  AddCameraOptions(command, request.camera);
}

// Names of sheets where there are sheets, else of tables.
template <std::size_t Count>
void CheckNames(
  const std::vector<std::string>& only, const char* const (&names)[Count], const std::string& what)
{
  std::string known;
  for (const char* name : names)
  {
    known += (known.empty() ? "" : ", ") + std::string(name);
  }
  for (const std::string& name : only)
  {
    if (std::find(std::begin(names), std::end(names), name) == std::end(names))
    {
      throw CLI::ValidationError("--only", "'" + name + "' is no " + what + "; there are " + known);
    }
  }
}

// Each of the options, if given, belongs to what is not asked for.
void RefuseOptions(
  const CLI::App& command, const std::vector<std::string>& names, const std::string& why)
{
  for (const std::string& name : names)
  {
    if (command.count(name) > 0)
    {
      throw CLI::ValidationError(name, why);
    }
  }
}

CommandAction ChooseComparison(const CLI::App& command, std::shared_ptr<const BenchOptions> options)
{
  RefuseOptions(command, {"input"}, "is not for --compare, which takes two files of --json");
  RefuseOptions(command, {"--sheets"}, "draws; --compare measures and draws nothing");
  return [options] { return RunBenchComparison(*options); };
}

CommandAction ChooseSheets(const CLI::App& command, std::shared_ptr<const BenchOptions> options)
{
  RefuseOptions(command, {"--hours", "--runs"}, "is of the tables; leave out --sheets");
  CheckNames(options->only, scene::sheetNames, "sheet");
  return [options] { return RunBenchSheets(*options); };
}

CommandAction ChooseTables(const CLI::App& command, std::shared_ptr<const BenchOptions> options)
{
  RefuseOptions(command, {"--time", "--size", "--azimuth", "--tilt", "--zoom", "--parallel"},
    "is of --sheets FOLDER");
  CheckNames(options->only, tableNames, "table");
  return [options] { return RunBenchTables(*options); };
}

// What the command line asks for, when it can be met.
CommandAction ChooseWork(const CLI::App& command, const std::shared_ptr<BenchOptions>& options)
{
  if (options->request.dimensions.empty())
  {
    for (const ThesisFigures& figures : ThesisTables)
    {
      options->request.dimensions.push_back(figures.dimensions);
    }
  }
  if (options->request.options.method == MergeMethod::Thesis)
  {
    RefuseOptions(
      command, {"--quality"}, "is of the method 'beam'; 'thesis' does not have this option");
  }
  return !options->compare.empty()         ? ChooseComparison(command, options)
         : !options->sheets.folder.empty() ? ChooseSheets(command, options)
                                           : ChooseTables(command, options);
}

} // namespace

void AddBenchOptions(CLI::App& command, CommandAction& action)
{
  const auto options = std::make_shared<BenchOptions>();
  AddOptions(command, *options);
  AddSheets(command, options->sheets);
  command.callback([&command, options, &action] { action = ChooseWork(command, options); });
}

} // namespace nexrad::application

// SPDX-License-Identifier: BSD-3-Clause
#include "BenchCommand.h"

#include "Bench/BenchRequest.h"
#include "Bench/DecodeTable.h"
#include "Bench/GridTable.h"
#include "Bench/Machine.h"
#include "Bench/SeriesMeasurement.h"
#include "Bench/ThesisFigures.h"
#include "Bench/WorkFolder.h"
#include "Model/Error.h"
#include "ProgressBar.h"
#include "SimulatedFiles.h"
#include "Temporal/InputFiles.h"
#include "Temporal/SiteSeries.h"
#include "Temporal/TimeMerge.h"
#include "UnitOptions.h"

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <iostream>
#include <memory>

namespace fs = std::filesystem;

namespace nexrad::application
{
namespace
{

struct BenchOptions
{
  std::vector<fs::path> inputs;
  BenchRequest request;
  double hours = 0.5;
  bool json = false;
  bool quiet = false;
};

struct BenchReport
{
  std::vector<BenchTable> tables;
  std::vector<std::string> problems; ///< files and tables that were left out, a line each
};

std::string ParseMethod(const std::string& text)
{
  if (!ParseMergeMethod(text))
  {
    throw Error("'" + text + "' is no method of merging; nexrad3d grid --help names them");
  }
  return text;
}

// The storms of the synthetic day are at their height from 18:00 UTC on; a whole day starts at
// midnight.
SimulatedDayOptions MakeDay(double hours)
{
  constexpr double wholeDay = 24.0;
  SimulatedDayOptions day;
  day.begin = *ParseIso8601(hours < wholeDay ? "2006-03-12T18:00" : "2006-03-12");
  day.length = Duration(static_cast<Duration::rep>(hours * 3'600'000.0));
  return day;
}

std::vector<fs::path> FindFiles(const BenchOptions& options, const fs::path& folder)
{
  if (!options.inputs.empty())
  {
    return FindInputFiles(options.inputs).paths;
  }
  ProgressBar bar("simulating", options.quiet);
  const auto show = [&bar](double fraction) { return bar.Update(fraction); };
  return WriteSimulatedFiles(MakeDay(options.hours), folder, show).files;
}

// What can be merged of the files.
SeriesScan ScanFiles(const BenchRequest& request)
{
  SeriesOptions options;
  options.moment = request.options.moment;
  options.requirePosition = true;
  return ScanInputs(request.files, options).value_or(SeriesScan());
}

bool AnySynthetic(const SeriesScan& scan)
{
  return std::any_of(scan.sites.begin(), scan.sites.end(),
    [](const SiteSeries& site) { return site.volumes.front().synthetic; });
}

// A simulated series has many files alike; one of each site speaks for all.
std::vector<fs::path> FirstOfEachSite(const SeriesScan& scan)
{
  std::vector<fs::path> files;
  for (const SiteSeries& site : scan.sites)
  {
    files.push_back(site.volumes.front().file);
  }
  return files;
}

// Files need not be a series: then they are decoded, and the reason stands among the problems.
void AddSeriesTables(
  const BenchRequest& request, const SeriesScan& scan, const fs::path& folder, BenchReport& report)
{
  try
  {
    if (scan.sites.empty())
    {
      throw Error("no file holds a ray of " + std::string(ToString(request.options.moment)));
    }
    report.tables.push_back(MakeGridTable(request, scan));
    const SeriesMeasurement series = MeasureSeries(request, folder);
    report.tables.push_back(MakeProcessingTable(request, series));
    report.tables.push_back(MakeSizeTable(series));
    report.tables.push_back(MakeSeriesTable(request, series));
  }
  catch (const Error& error)
  {
    report.problems.push_back(std::string("merging is not measured: ") + error.what());
  }
}

void PrintJson(const BenchRequest& request, const Machine& machine, const BenchReport& report)
{
  nlohmann::ordered_json json = {{"processor", machine.processor}, {"cores", machine.cores},
    {"build", machine.build}, {"runs", request.runs}, {"synthetic", request.synthetic},
    {"files", request.files.size()}};
  for (const BenchTable& table : report.tables)
  {
    json["tables"][table.key] = MakeTableJson(table);
  }
  std::cout << json.dump(1, ' ', false, nlohmann::json::error_handler_t::replace) << '\n';
}

void PrintText(const BenchRequest& request, const Machine& machine, const BenchReport& report)
{
  std::cout << machine.processor << ", " << machine.cores << " cores; " << machine.build << "\n"
            << request.files.size() << (request.files.size() == 1 ? " file" : " files")
            << (request.synthetic ? ", SYNTHETIC" : "")
            << "; times in seconds are medians (least..most) of " << request.runs << " runs\n\n";
  for (const BenchTable& table : report.tables)
  {
    PrintTable(table, std::cout);
  }
}

int RunBench(const BenchOptions& options)
{
  const WorkFolder folder;
  BenchRequest request = options.request;
  request.files = FindFiles(options, folder.Path() / "level2");
  const SeriesScan scan = ScanFiles(request);
  request.synthetic = AnySynthetic(scan);
  BenchReport report;
  const std::vector<fs::path> files = request.synthetic ? FirstOfEachSite(scan) : request.files;
  report.tables.push_back(MakeDecodeTable(files, request.runs, report.problems));
  AddSeriesTables(request, scan, folder.Path(), report);
  const Machine machine = DescribeMachine();
  options.json ? PrintJson(request, machine, report) : PrintText(request, machine, report);
  for (const std::string& problem : report.problems)
  {
    std::cerr << problem << '\n';
  }
  const bool nothing = report.tables.size() == 1 && report.tables.front().rows.empty();
  return nothing ? Failed : report.problems.empty() ? Done : DoneWithDamage;
}

void AddOptions(CLI::App& command, BenchOptions& options)
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
  command.add_option("--runs", options.request.runs, "How often everything is measured")
    ->type_name("NUMBER")
    ->check(CLI::Range(1, 1000))
    ->capture_default_str();
  const auto addDimensions = [&options](const std::string& text)
  {
    try
    {
      options.request.dimensions.push_back(ParseDimensions(text));
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
  AddParsedOption(command, "--method", options.request.options.method, ParseMethod, "NAME",
    "How rays become voxels", options.request.options.method);
  command.add_flag("--json", options.json, "Print JSON; times in seconds (default: tables)");
  AddQuietOption(command, options.quiet);
}

} // namespace

void AddBenchCommand(CLI::App& program, CommandAction& action)
{
  const auto options = std::make_shared<BenchOptions>();
  CLI::App* command = program.add_subcommand("bench",
    "Measure decoding and merging on this machine, beside bare decompression and the thesis's "
    "figures");
  AddOptions(*command, *options);
  const auto run = [options]
  {
    if (options->request.dimensions.empty())
    {
      for (const ThesisFigures& figures : ThesisTables)
      {
        options->request.dimensions.push_back(figures.dimensions);
      }
    }
    return RunBench(*options);
  };
  command->callback([run, &action] { action = run; });
}

} // namespace nexrad::application

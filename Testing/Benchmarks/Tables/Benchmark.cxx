// SPDX-License-Identifier: BSD-3-Clause
#include "Tables/Benchmark.h"

#include "Commands/SimulatedFiles.h"
#include "Options/UnitOptions.h"
#include "Tables/ThesisFigures.h"
#include "TestData.h"
#include "nexrad/Merging/TimeMerge.h"
#include "nexrad/Series/InputFiles.h"
#include "nexrad/Series/ScanInputs.h"
#include "nexrad/Series/VolumeSelection.h"
#include "nexrad/System/Error.h"

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <iostream>

namespace fs = std::filesystem;

namespace nexrad::application
{
namespace
{

struct BenchOptions
{
  std::vector<fs::path> inputs; ///< empty: a series is simulated
  double hours = 0.5;           ///< of the simulated series
  std::vector<std::string> dimensions;
  std::vector<std::string> only; ///< names of parts; empty: all
  bool json = false;
};

std::vector<std::string> NamesOf(const std::vector<BenchPart>& parts)
{
  std::vector<std::string> names;
  for (const BenchPart& part : parts)
  {
    names.emplace_back(part.name);
  }
  return names;
}

void AddOptions(CLI::App& program, BenchOptions& options, BenchRequest& request)
{
  program.add_option("input", options.inputs,
    "Radar files, or folders of them (default: a synthetic series is simulated)");
  program
    .add_option("--hours", options.hours,
      "Length of the synthetic series in hours; from 18:00 UTC on, a whole day from midnight")
    ->check(CLI::Range(0.25, 24.0))
    ->capture_default_str();
  program
    .add_option("--runs", request.runs,
      "How often everything is measured; frames are seen from as many sides")
    ->check(CLI::Range(1, 1000))
    ->capture_default_str();
  program
    .add_option("--dims", options.dimensions,
      "Voxels of the merged volumes, as 256x256x128; may be given many times (default: the "
      "thesis's three)")
    ->allow_extra_args(false);
  for (const char* key : {"method", "quality", "max-gap"})
  {
    AddSetting(program, *FindSetting(MergeSettings(), key), request.options);
  }
  program.add_flag("--json", options.json, "Print JSON, units in the names (default: tables)");
}

// The storms of the synthetic day are at their height from 18:00 UTC on; a whole day starts at
// midnight.
std::vector<fs::path> Simulate(double hours, const fs::path& folder)
{
  constexpr double wholeDay = 24.0;
  SimulatedDayOptions day;
  day.begin = *ParseIso8601(hours < wholeDay ? "2006-03-12T18:00" : "2006-03-12");
  day.length = Duration(static_cast<Duration::rep>(hours * 3'600'000.0));
  return WriteSimulatedFiles(day, folder).files;
}

void Prepare(const BenchOptions& options, BenchRequest& request)
{
  for (const std::string& text : options.dimensions)
  {
    request.dimensions.push_back(ParseDimensions(text));
  }
  if (request.dimensions.empty())
  {
    for (const ThesisFigures& figures : ThesisTables)
    {
      request.dimensions.push_back(figures.dimensions);
    }
  }
  request.files = options.inputs.empty() ? Simulate(options.hours, request.folder / "level2")
                                         : FindInputFiles(options.inputs).paths;
  SeriesOptions series;
  series.moments = request.options.moments;
  series.requirePosition = true;
  request.scan = ScanInputs(request.files, series).value_or(SeriesScan());
  request.synthetic = std::any_of(request.scan.sites.begin(), request.scan.sites.end(),
    [](const SiteSeries& site) { return site.volumes.front().synthetic; });
}

// Files need not be a series, and there need not be a display: the reason stands among the
// problems.
BenchReport Measure(
  const BenchOptions& options, const BenchRequest& request, const std::vector<BenchPart>& parts)
{
  BenchReport report;
  report.machine = DescribeMachine();
  report.runs = request.runs;
  report.synthetic = request.synthetic;
  report.files = request.files.size();
  for (const BenchPart& part : parts)
  {
    if (options.only.empty() ||
        std::find(options.only.begin(), options.only.end(), part.name) != options.only.end())
    {
      try
      {
        part.measure(request, report);
      }
      catch (const Error& error)
      {
        report.problems.push_back(std::string(part.name) + " is not measured: " + error.what());
      }
    }
  }
  return report;
}

int Print(const BenchReport& report, bool json)
{
  if (json)
  {
    std::cout << MakeReportJson(report).dump(1) << '\n';
  }
  else
  {
    PrintReport(report, std::cout);
  }
  for (const std::string& problem : report.problems)
  {
    std::cerr << problem << '\n';
  }
  const bool nothing = std::all_of(report.tables.begin(), report.tables.end(),
    [](const BenchTable& table) { return table.rows.empty(); });
  return nothing ? 1 : report.problems.empty() ? 0 : 3;
}

} // namespace

std::vector<Time> StepsOf(const BenchRequest& request)
{
  if (request.scan.sites.empty())
  {
    throw Error("no file holds a ray of " + std::string(ToString(request.options.moments.front())));
  }
  std::vector<Time> times = TimeSteps(
    *request.scan.First(), *request.scan.Last(), request.options.step.value_or(DefaultStep));
  if (times.size() < 2)
  {
    throw Error("the files cover less than two time steps; give more files");
  }
  return times;
}

int RunBenchmark(
  int argc, const char* const* argv, const std::string& does, const std::vector<BenchPart>& parts)
{
  const nexrad::testing::TemporaryFolder folder;
  BenchOptions options;
  BenchRequest request;
  request.folder = folder.Path();
  CLI::App program(does);
  AddOptions(program, options, request);
  program.add_option("--only", options.only, "These parts alone, as in A,B")
    ->delimiter(',')
    ->check(CLI::IsMember(NamesOf(parts)));
  try
  {
    program.parse(argc, argv);
    Prepare(options, request);
    return Print(Measure(options, request, parts), options.json);
  }
  catch (const CLI::ParseError& error)
  {
    return program.exit(error) == 0 ? 0 : 2;
  }
  catch (const std::exception& error)
  {
    std::cerr << argv[0] << ": " << error.what() << '\n';
    return 1;
  }
}

} // namespace nexrad::application

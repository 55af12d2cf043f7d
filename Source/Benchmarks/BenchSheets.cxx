// SPDX-License-Identifier: BSD-3-Clause
#include "BenchSheets.h"

#include "BenchOutput.h"
#include "Commands/Command.h"
#include "Commands/SimulatedFiles.h"
#include "DrawingLibrary.h"
#include "Output/ProgressBar.h"
#include "Tables/WorkFolder.h"
#include "nexrad/Series/InputFiles.h"
#include "nexrad/System/Progress.h"

#include <nlohmann/json.hpp>

#include <iostream>

namespace fs = std::filesystem;

namespace nexrad::application
{
namespace
{

// The times of the thesis's figure 4.1, on the synthetic day.
constexpr const char* wantedTimes[] = {
  "2006-03-12T00:10", "2006-03-12T06:10", "2006-03-12T18:10", "2006-03-12T23:10"};
constexpr std::size_t stormyTime = 2; // storms are at their height

// Of a synthetic day only what is drawn: the volumes about those times, of each radar one before
// and one after at least.
std::vector<fs::path> SimulateAbout(const fs::path& folder, const Progress& progress)
{
  std::vector<fs::path> files;
  for (std::size_t i = 0; i < std::size(wantedTimes); ++i)
  {
    SimulatedDayOptions day;
    day.begin = *ParseIso8601(wantedTimes[i]) - std::chrono::minutes(8);
    day.length = std::chrono::minutes(15);
    const Progress part = ShareOf(progress, i, std::size(wantedTimes));
    const auto written = WriteSimulatedFiles(day, folder, part).files;
    files.insert(files.end(), written.begin(), written.end());
  }
  return files;
}

// The synthetic day's files need not reach over the times to be steps of the day.
void Simulate(const BenchOptions& options, const fs::path& folder, scene::SheetRequest& request)
{
  ProgressBar bar("simulating", options.quiet);
  request.files = SimulateAbout(folder, [&bar](double done) { return bar.Update(done); });
  request.grid.begin = ParseIso8601(wantedTimes[0]);
  request.grid.end = ParseIso8601(wantedTimes[std::size(wantedTimes) - 1]);
  request.time = request.time ? request.time : ParseIso8601(wantedTimes[stormyTime]);
}

void PrintTables(const scene::SheetReport& report, bool json)
{
  if (!json)
  {
    for (const BenchTable& table : report.tables)
    {
      PrintTable(table, std::cout);
    }
    for (const fs::path& output : report.outputs)
    {
      std::cout << output.string() << '\n';
    }
    return;
  }
  nlohmann::ordered_json tables = nlohmann::ordered_json::object();
  for (const BenchTable& table : report.tables)
  {
    tables[table.key] = MakeTableJson(table);
  }
  PrintJson({{"tables", tables}});
}

} // namespace

int RunBenchSheets(const BenchOptions& options)
{
  const WorkFolder folder;
  scene::SheetRequest request = options.sheets;
  request.grid = options.request.options;
  request.dimensions = options.request.dimensions;
  request.only = options.only;
  if (options.inputs.empty())
  {
    Simulate(options, folder.Path(), request);
  }
  else
  {
    request.files = FindInputFiles(options.inputs).paths;
  }
  ProgressBar bar("drawing", options.quiet);
  request.progress = [&bar](double fraction) { return bar.Update(fraction); };
  const scene::SheetReport report = DrawSheetsWithLibrary(request);
  bar.Clear();
  PrintTables(report, options.json);
  const int status = PrintProblems(report.problems);
  return report.outputs.empty() ? Failed : status;
}

} // namespace nexrad::application

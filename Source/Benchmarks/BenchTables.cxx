// SPDX-License-Identifier: BSD-3-Clause
#include "BenchTables.h"

#include "BenchOutput.h"
#include "Commands/Command.h"
#include "Commands/SimulatedFiles.h"
#include "DrawingLibrary.h"
#include "Output/ProgressBar.h"
#include "Report/BenchReport.h"
#include "Tables/DecodeTable.h"
#include "Tables/DrawingTables.h"
#include "Tables/GridTable.h"
#include "Tables/SeriesMeasurement.h"
#include "Tables/SeriesTables.h"
#include "Tables/WorkFolder.h"
#include "nexrad/Series/InputFiles.h"
#include "nexrad/Series/ScanInputs.h"
#include "nexrad/System/Error.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <iostream>

namespace fs = std::filesystem;

namespace nexrad::application
{
namespace
{

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

/// One run: what is measured and what came of it.
class TableRun
{
public:
  TableRun(const BenchOptions& benchOptions, const fs::path& workFolder)
    : options(benchOptions)
    , folder(workFolder)
    , request(benchOptions.request)
  {
    request.files = FindFiles(options, folder / "level2");
    scan = ScanFiles(request);
    request.synthetic = AnySynthetic(scan);
    report.machine = DescribeMachine();
    report.runs = request.runs;
    report.synthetic = request.synthetic;
    report.files = request.files.size();
  }

  void Measure()
  {
    if (this->Wants("decode"))
    {
      const auto files = request.synthetic ? FirstOfEachSite(scan) : request.files;
      report.tables.push_back(MakeDecodeTable(files, request.runs, problems));
    }
    this->Try("merging", [this] { this->MeasureMerging(); });
    this->Try("drawing", [this] { this->MeasureDrawing(); });
  }

  const BenchReport& Report() const { return report; }
  const std::vector<std::string>& Problems() const { return problems; }

private:
  bool Wants(const std::string& name) const
  {
    return options.only.empty() ||
           std::find(options.only.begin(), options.only.end(), name) != options.only.end();
  }

  // Files need not be a series, and there need not be a display: the reason stands among the
  // problems.
  template <typename Work>
  void Try(const std::string& what, const Work& work)
  {
    try
    {
      work();
    }
    catch (const Error& error)
    {
      problems.push_back(what + " is not measured: " + error.what());
    }
  }

  void RequireSeries() const
  {
    if (scan.sites.empty())
    {
      throw Error("no file holds a ray of " + std::string(ToString(request.options.moment)));
    }
  }

  void MeasureMerging()
  {
    if (this->Wants("grid"))
    {
      this->RequireSeries();
      report.tables.push_back(MakeGridTable(request, scan));
    }
    if (this->Wants("series"))
    {
      this->RequireSeries();
      const SeriesMeasurement series = MeasureSeries(request, folder);
      report.tables.push_back(MakeProcessingTable(request, series));
      report.tables.push_back(MakeSizeTable(series));
      report.tables.push_back(MakeSeriesTable(request, series));
    }
  }

  void MeasureDrawing()
  {
    if (!this->Wants("drawing"))
    {
      return;
    }
    this->RequireSeries();
    DrawingRequest drawing = PrepareDrawing(request, scan, folder);
    ProgressBar bar("drawing", options.quiet);
    drawing.progress = [&bar](double fraction) { return bar.Update(fraction); };
    const DrawingReport times = MeasureDrawingWithLibrary(drawing);
    report.machine.opengl = times.opengl;
    report.tables.push_back(MakeRenderingTable(times, request.synthetic));
    report.tables.push_back(MakeFrameRateTable(times, request.synthetic));
  }

  const BenchOptions& options;
  const fs::path folder;
  BenchRequest request;
  SeriesScan scan;
  BenchReport report;
  std::vector<std::string> problems; ///< files and tables that were left out, a line each
};

bool IsEmpty(const BenchReport& report)
{
  return std::all_of(report.tables.begin(), report.tables.end(),
    [](const BenchTable& table) { return table.rows.empty(); });
}

} // namespace

int RunBenchTables(const BenchOptions& options)
{
  const WorkFolder folder;
  TableRun run(options, folder.Path());
  run.Measure();
  if (options.json)
  {
    PrintJson(MakeReportJson(run.Report()));
  }
  else
  {
    PrintReport(run.Report(), std::cout);
  }
  const int status = PrintProblems(run.Problems());
  return IsEmpty(run.Report()) ? Failed : status;
}

} // namespace nexrad::application

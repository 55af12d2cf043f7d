// SPDX-License-Identifier: BSD-3-Clause
#include "Sheets.h"

#include "Bench/BenchRequest.h"
#include "Drawing/PictureWindow.h"
#include "Output/OutputFile.h"
#include "Scene/Series/RadarFiles.h"
#include "nexrad/Series/VolumeSelection.h"
#include "nexrad/System/Error.h"
#include "nexrad/System/ProgressShare.h"

#include <vtkImageData.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <iterator>

namespace fs = std::filesystem;

namespace nexrad::scene
{
namespace
{

// In the order of sheetNames.
constexpr Sheet (*drawers[])(const SheetSource&) = {
  DrawResolutionSheet, DrawSlicesSheet, DrawTimesSheet, DrawSweepsSheet};

// Throws Error for a time when no radar was seen.
void CheckTime(const SheetSource& source)
{
  const Duration gap = source.request.grid.maximumGap;
  const Time first = *source.scan.First();
  const Time last = *source.scan.Last();
  if (source.time < first - gap || source.time > last + gap)
  {
    throw Error("no ray about " + FormatIso8601(source.time) + "; the files reach from " +
                FormatIso8601(first) + " to " + FormatIso8601(last));
  }
}

SheetSource MakeSource(const SheetRequest& request)
{
  SeriesOptions options;
  options.moment = request.grid.moment;
  options.requirePosition = true;
  SheetSource source{request, ScanInputs(request.files, options).value_or(SeriesScan())};
  const SeriesScan& scan = source.scan;
  if (scan.sites.empty())
  {
    throw Error("no file holds a ray of " + std::string(ToString(request.grid.moment)));
  }
  source.synthetic = std::any_of(scan.sites.begin(), scan.sites.end(),
    [](const SiteSeries& site) { return site.volumes.front().synthetic; });
  const Duration step = request.grid.step.value_or(DefaultStep);
  const std::vector<Time> steps = TimeSteps(*scan.First(), *scan.Last(), step);
  const Time middle = *scan.First() + (*scan.Last() - *scan.First()) / 2;
  source.time = request.time.value_or(steps.empty() ? middle : steps[steps.size() / 2]);
  CheckTime(source);
  return source;
}

void WriteSheet(const Sheet& sheet, const SheetSource& source, SheetReport& report)
{
  const fs::path picture = source.request.folder / (sheet.table.key + ".png");
  const fs::path numbers = source.request.folder / (sheet.table.key + ".json");
  WritePng(sheet.picture, picture);
  nlohmann::ordered_json json = application::MakeTableJson(sheet.table);
  json["synthetic"] = source.synthetic;
  const std::string text =
    json.dump(1, ' ', false, nlohmann::json::error_handler_t::replace) + '\n';
  application::WriteFile(numbers, reinterpret_cast<const unsigned char*>(text.data()), text.size());
  report.outputs.insert(report.outputs.end(), {picture, numbers});
  report.tables.push_back(sheet.table);
}

bool IsWanted(const SheetRequest& request, const std::string& name)
{
  return request.only.empty() ||
         std::find(request.only.begin(), request.only.end(), name) != request.only.end();
}

std::unique_ptr<VolumeSeries> Merge(
  const SheetSource& source, const std::array<int, 3>& dimensions, MergeOptions options)
{
  options.grid.dimensions = dimensions;
  return OpenRadarFiles(source.request.files, options);
}

} // namespace

std::unique_ptr<VolumeSeries> SheetSource::MergeAtTime(const std::array<int, 3>& dimensions) const
{
  MergeOptions options = request.grid;
  options.begin = options.end = time;
  options.step = Duration(1); // every millisecond is a step, so that the time itself is one
  return Merge(*this, dimensions, options);
}

std::unique_ptr<VolumeSeries> SheetSource::MergeAllSteps(const std::array<int, 3>& dimensions) const
{
  return Merge(*this, dimensions, request.grid);
}

const std::array<int, 3>& SheetSource::MiddleSize() const
{
  return request.dimensions[request.dimensions.size() / 2];
}

std::string SheetSource::Title(const std::string& what) const
{
  return what + (synthetic ? ", SYNTHETIC" : "");
}

SheetReport DrawSheets(const SheetRequest& request)
{
  RequireDisplay();
  application::MakeFolder(request.folder);
  const SheetSource source = MakeSource(request);
  SheetReport report;
  for (const InputProblem& problem : source.scan.problems)
  {
    report.problems.push_back(problem.Line());
  }
  for (std::size_t i = 0; i < std::size(drawers); ++i)
  {
    if (IsWanted(request, sheetNames[i]))
    {
      try
      {
        WriteSheet(drawers[i](source), source, report);
      }
      catch (const Error& error)
      {
        report.problems.push_back(
          "the sheet " + std::string(sheetNames[i]) + " is not drawn: " + error.what());
      }
    }
    if (request.progress)
    {
      request.progress(static_cast<double>(i + 1) / std::size(drawers));
    }
  }
  return report;
}

} // namespace nexrad::scene

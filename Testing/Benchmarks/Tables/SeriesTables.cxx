// SPDX-License-Identifier: BSD-3-Clause
#include "Tables/SeriesTables.h"

#include "Tables/BareDecompression.h"
#include "Tables/PeakMemory.h"
#include "Tables/ThesisFigures.h"
#include "Volumes/WriteVolumes.h"
#include "nexrad/Codec/NxvFile.h"
#include "nexrad/Codec/ThesisStream.h"
#include "nexrad/System/Error.h"
#include "vtkNexradThreads.h"

#include <algorithm>
#include <cstdio>
#include <memory>
#include <numeric>

namespace nexrad::application
{
namespace
{

GridJob MakeJob(const BenchRequest& request, const std::array<int, 3>& dimensions)
{
  GridJob job;
  job.inputs = request.files;
  job.folder = request.folder / FormatDimensions(dimensions);
  job.options = request.options;
  job.options.grid.dimensions = dimensions;
  return job;
}

// Bare decompression of all files on the threads that merging has. Empty when one of them has no
// such time.
std::function<void()> MakeBareWork(
  const std::vector<std::filesystem::path>& files, double& storedBytes)
{
  try
  {
    const auto series = std::make_shared<BareSeries>(files, vtkNexradThreadCount());
    storedBytes = series->StoredBytes();
    return [series] { series->Run(); };
  }
  catch (const Error&)
  {
    return {}; // the table of decoding names the file
  }
}

// What one size came to in all runs.
struct Outcome
{
  GridReport report;
  std::optional<double> peakBytes;

  void Run(const GridJob& job)
  {
    RestartPeakMemory();
    report = WriteVolumes(job);
    const std::optional<double> peak = PeakMemory();
    peakBytes = peak ? std::max(*peak, peakBytes.value_or(0.0)) : peak;
  }
};

// Of a long series some tell enough, each reading and writing again.
double MeanThesisBytes(const GridReport& report)
{
  constexpr std::size_t enough = 48;
  const std::size_t stride = (report.files.size() + enough - 1) / enough;
  std::vector<double> sizes;
  for (std::size_t i = 0; i < report.files.size(); i += stride)
  {
    const GriddedVolume volume = ReadNxv(report.files[i]);
    sizes.push_back(static_cast<double>(EncodeRunLength(ThesisCode::EncodeAll(volume)).size()));
  }
  return std::accumulate(sizes.begin(), sizes.end(), 0.0) / static_cast<double>(sizes.size());
}

SeriesOfSize Describe(const Outcome& outcome, const GridJob& job, const Measurement& seconds)
{
  const GridReport& report = outcome.report;
  SeriesOfSize size;
  size.peakBytes = outcome.peakBytes;
  size.dimensions = job.options.grid.dimensions;
  size.seconds = seconds;
  size.volumes = report.files.size();
  size.bytes = static_cast<double>(report.bytes) / static_cast<double>(report.files.size());
  size.thesisBytes = MeanThesisBytes(report);
  return size;
}

} // namespace

SeriesMeasurement MeasureSeries(const BenchRequest& request)
{
  SeriesMeasurement series;
  series.files = request.files.size();
  std::vector<std::function<void()>> pieces;
  std::vector<Outcome> outcomes(request.dimensions.size());
  for (std::size_t index = 0; index < request.dimensions.size(); ++index)
  {
    const GridJob job = MakeJob(request, request.dimensions[index]);
    pieces.push_back([job, &outcome = outcomes[index]] { outcome.Run(job); });
  }
  const std::function<void()> bare = MakeBareWork(request.files, series.storedBytes);
  if (bare)
  {
    pieces.push_back(bare);
  }
  // Each run is many files long: a run before them would warm nothing that lasts.
  const std::vector<Measurement> times = MeasureInTurn(pieces, request.runs, false);
  for (std::size_t index = 0; index < outcomes.size(); ++index)
  {
    const GridJob job = MakeJob(request, request.dimensions[index]);
    series.sizes.push_back(Describe(outcomes[index], job, times[index]));
    std::filesystem::remove_all(job.folder);
  }
  if (bare)
  {
    series.bare = times.back();
  }
  return series;
}

BenchTable MakeProcessingTable(const BenchRequest& request, const SeriesMeasurement& series)
{
  constexpr double volumesPerDay = 288.0; // one every five minutes
  BenchTable table;
  table.key = "processing";
  table.title = "Thesis, table 4.1: from radar files to volume files, method " +
                NameOf(request.options.method) + "; a day is " + "288 times a volume";
  table.columns = {NameColumn("dimensions", "voxels"),
    GivenColumn("thesis_s_per_volume", "thesis, s a volume"),
    {"s_per_volume", "here, s a volume", 3}, GivenColumn("thesis_min_per_day", "thesis, min a day"),
    {"min_per_day", "here, min a day", 2}};
  for (const SeriesOfSize& size : series.sizes)
  {
    const ThesisFigures* thesis = FindThesisFigures(size.dimensions);
    const double seconds = size.seconds.median / static_cast<double>(size.volumes);
    table.rows.push_back({FormatDimensions(size.dimensions),
      thesis ? BenchCell(thesis->secondsPerVolume) : BenchCell(), seconds,
      thesis ? BenchCell(thesis->minutesPerDay) : BenchCell(), seconds * volumesPerDay / 60.0});
  }
  return table;
}

BenchTable MakeSizeTable(const SeriesMeasurement& series)
{
  BenchTable table;
  table.key = "sizes";
  table.title = "Thesis, table 4.4: bytes of a volume before (one a voxel) and after compression; "
                "here the mean of all volumes";
  table.columns = {NameColumn("dimensions", "voxels"), GivenColumn("bytes_before", "before, B"),
    GivenColumn("thesis_bytes_after", "thesis, after, B"),
    GivenColumn("thesis_saved_percent", "thesis, saved %", 2),
    {"run_length_bytes_after", "here, the thesis's code, B"}, {"nxv_bytes_after", "here, .nxv, B"},
    {"nxv_saved_percent", "here, saved %", 2}};
  for (const SeriesOfSize& size : series.sizes)
  {
    const ThesisFigures* thesis = FindThesisFigures(size.dimensions);
    const auto& [x, y, z] = size.dimensions;
    const double before = static_cast<double>(x) * y * z;
    table.rows.push_back({FormatDimensions(size.dimensions), before,
      thesis ? BenchCell(thesis->bytesAfter) : BenchCell(),
      thesis ? BenchCell(thesis->savedPercent) : BenchCell(), size.thesisBytes, size.bytes,
      100.0 * (1.0 - size.bytes / before)});
  }
  return table;
}

BenchTable MakeSeriesTable(const BenchRequest& request, const SeriesMeasurement& series)
{
  char megabytes[32];
  std::snprintf(megabytes, sizeof megabytes, "%.1f", series.storedBytes / 1e6);
  BenchTable table;
  table.key = "series";
  table.title = "All files to volume files, method " + NameOf(request.options.method) + ": " +
                std::to_string(series.files) + " files" +
                (series.bare ? ", " + std::string(megabytes) + " MB" : std::string()) +
                (request.synthetic ? ", SYNTHETIC" : "");
  table.columns = {NameColumn("dimensions", "voxels"), GivenColumn("volumes", "volumes"),
    {"bare_s", "bare decompression, s", 2}, {"series_s", "all, s", 2}, {"ratio", "ratio", 2},
    {"peak_mib", "peak memory, MiB", 0}};
  for (const SeriesOfSize& size : series.sizes)
  {
    table.rows.push_back({FormatDimensions(size.dimensions), static_cast<double>(size.volumes),
      series.bare ? BenchCell(*series.bare) : BenchCell(), size.seconds,
      series.bare ? BenchCell(size.seconds.median / series.bare->median) : BenchCell(),
      size.peakBytes ? BenchCell(*size.peakBytes / 1048576.0) : BenchCell()});
  }
  return table;
}

} // namespace nexrad::application

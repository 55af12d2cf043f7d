// SPDX-License-Identifier: BSD-3-Clause
#include "Tables/SeriesTables.h"

#include "Tables/ThesisFigures.h"

#include <cstdio>

namespace nexrad::application
{

BenchTable MakeProcessingTable(const BenchRequest& request, const SeriesMeasurement& series)
{
  constexpr double volumesPerDay = 288.0; // one every five minutes
  BenchTable table;
  table.key = "processing";
  table.title = "Thesis, table 4.1: from radar files to volume files, method " +
                std::string(ToString(request.options.method)) + "; a day is " +
                "288 times a volume";
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
  table.title = std::string("All files to volume files, method ") +
                ToString(request.options.method) + ": " + std::to_string(series.files) + " files" +
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

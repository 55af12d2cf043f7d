// SPDX-License-Identifier: BSD-3-Clause
#include "Bench/SeriesMeasurement.h"

#include <cstdio>

namespace nexrad::application
{

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

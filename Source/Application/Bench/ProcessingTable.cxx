// SPDX-License-Identifier: BSD-3-Clause
#include "Bench/SeriesMeasurement.h"
#include "Bench/ThesisFigures.h"

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

} // namespace nexrad::application

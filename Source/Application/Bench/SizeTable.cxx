// SPDX-License-Identifier: BSD-3-Clause
#include "Bench/SeriesMeasurement.h"
#include "Bench/ThesisFigures.h"

namespace nexrad::application
{

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

} // namespace nexrad::application

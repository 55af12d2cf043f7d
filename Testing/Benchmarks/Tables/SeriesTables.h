// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Tables/BenchTable.h"
#include "Tables/Benchmark.h"
#include "Tables/Measurement.h"

#include <cstddef>
#include <optional>
#include <vector>

namespace nexrad::application
{

/// A series of radar files made into volume files of one size.
struct SeriesOfSize
{
  std::array<int, 3> dimensions;
  Measurement seconds;             ///< from the radar files to the volume files and their index
  std::size_t volumes = 0;         ///< that were made
  std::optional<double> peakBytes; ///< largest resident memory of the process meanwhile
  double bytes = 0.0;              ///< of one volume file, the mean
  double thesisBytes = 0.0;        ///< of one volume in the thesis's code (T8), the mean of some
};

/// The same files for several sizes, and their bare decompression, measured in turn.
struct SeriesMeasurement
{
  std::size_t files = 0;
  double storedBytes = 0.0;        ///< of all files
  std::optional<Measurement> bare; ///< seconds; empty when a file cannot be compared
  std::vector<SeriesOfSize> sizes;
};

/// Merges the files of a request into volume files in its folder, which is emptied of them again.
/// Throws Error when they cannot be merged or written.
SeriesMeasurement MeasureSeries(const BenchRequest& request);

/// The thesis's table 4.1: seconds a volume and minutes a day of 288 volumes, with its figures.
BenchTable MakeProcessingTable(const BenchRequest& request, const SeriesMeasurement& series);

/// The thesis's table 4.4: bytes of a volume before and after compression, with its figures.
BenchTable MakeSizeTable(const SeriesMeasurement& series);

/// The whole series: seconds, volumes, and the ratio to bare decompression of the same files.
BenchTable MakeSeriesTable(const BenchRequest& request, const SeriesMeasurement& series);

} // namespace nexrad::application

// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Report/BenchTable.h"
#include "Tables/BenchRequest.h"
#include "Tables/SeriesMeasurement.h"

namespace nexrad::application
{

/// The thesis's table 4.1: seconds a volume and minutes a day of 288 volumes, with its figures.
BenchTable MakeProcessingTable(const BenchRequest& request, const SeriesMeasurement& series);

/// The thesis's table 4.4: bytes of a volume before and after compression, with its figures.
BenchTable MakeSizeTable(const SeriesMeasurement& series);

/// The whole series: seconds, volumes, and the ratio to bare decompression of the same files.
BenchTable MakeSeriesTable(const BenchRequest& request, const SeriesMeasurement& series);

} // namespace nexrad::application

// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Tables/BenchTable.h"
#include "Tables/Benchmark.h"
#include "Tables/MeasureDrawing.h"

namespace nexrad::application
{

/// What to measure drawing with: of each of the request's sizes one volume more than runs, one
/// after the other in the middle of the series, written below its folder. Throws Error when the
/// files cover less than two time steps, or cannot be merged or written.
DrawingRequest PrepareDrawing(const BenchRequest& request);

/// The thesis's table 4.2: t1, t2, t3 at 256 slices and their sum, in ms, with its figures and
/// those of VTK's GPU ray caster.
BenchTable MakeRenderingTable(const DrawingReport& report, bool synthetic);

/// The thesis's table 4.3: t3 and frames a second by size and number of slices.
BenchTable MakeFrameRateTable(const DrawingReport& report, bool synthetic);

} // namespace nexrad::application

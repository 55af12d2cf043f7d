// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "GridOptions.h"
#include "Temporal/SiteSeries.h"
#include "Temporal/TimeMerge.h"

#include <optional>
#include <vector>

namespace nexrad::application
{

/// What a user's options ask of a scan. Throws Error for a moment that the method does not know.
SeriesOptions SeriesOptionsOf(const GridOptions& options);

/// What they ask of a merge, but for grid and time; its rows run through vtkSMPTools.
MergeRequest MergeRequestOf(const GridOptions& options);

/// The time steps between the first and the last ray, or those that the options name. Throws Error
/// when there is none.
std::vector<Time> TimeStepsOf(const GridOptions& options, Time firstRay, Time lastRay);

/// Threads that vtkSMPTools uses, at least 1.
unsigned ThreadCount();

} // namespace nexrad::application

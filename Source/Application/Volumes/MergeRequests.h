// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "GridOptions.h"
#include "Temporal/SiteSeries.h"
#include "Temporal/TimeMerge.h"
#include "Temporal/VolumeSelection.h"

#include <cstddef>
#include <optional>
#include <vector>

namespace nexrad::application
{

/// What a user's options ask of a scan. Throws Error for a moment that the method does not know.
SeriesOptions SeriesOptionsOf(const GridOptions& options);

/// What they ask of a merge, but for grid and time; its rows run through vtkSMPTools.
MergeRequest MergeRequestOf(const GridOptions& options);

/// The grid that the options name, about radars whose own domain has a radius of `range` m.
GridSpecification GridOf(
  const GridOptions& options, const std::vector<Position>& positions, double range);

/// The time steps between the first and the last ray of `volumes` volumes, or those that the
/// options name. Throws Error when there is none.
std::vector<Time> TimeStepsOf(
  const GridOptions& options, Time firstRay, Time lastRay, std::size_t volumes);

/// A pause of days between volumes, of which the options do not say at which side of it to begin or
/// to end.
std::optional<TimeSpan> FindPause(const GridOptions& options, const std::vector<TimeSpan>& volumes);

/// The time steps of all volumes of a scan. Throws Error also for a pause of days, and for a time
/// alone at which nothing was scanned.
std::vector<Time> TimeStepsOf(const GridOptions& options, const SeriesScan& scan);

/// Threads that vtkSMPTools uses, at least 1.
unsigned ThreadCount();

} // namespace nexrad::application

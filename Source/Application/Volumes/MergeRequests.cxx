// SPDX-License-Identifier: BSD-3-Clause
#include "MergeRequests.h"

#include "Model/Error.h"
#include "Temporal/VolumeSelection.h"

#include <vtkSMPTools.h>

#include <algorithm>

namespace nexrad::application
{
namespace
{

void RunRows(int count, const std::function<void(int, int)>& work)
{
  constexpr vtkIdType grain = 1; // what is done is large, and costs unlike
  const auto run = [&work](vtkIdType begin, vtkIdType end)
  { work(static_cast<int>(begin), static_cast<int>(end)); };
  vtkSMPTools::For(0, count, grain, run);
}

} // namespace

SeriesOptions SeriesOptionsOf(const GridOptions& options)
{
  RequireMoment(*ParseMergeMethod(options.method), options.moment);
  SeriesOptions series;
  series.moment = options.moment;
  series.quality.neighbours = options.despeckle;
  series.requirePosition = true;
  series.level2.siteName = options.siteName;
  return series;
}

MergeRequest MergeRequestOf(const GridOptions& options)
{
  MergeRequest request;
  request.maximumGap = options.maximumGap;
  request.method = *ParseMergeMethod(options.method);
  request.quality.neighbours = options.despeckle;
  request.loop = RunRows;
  request.beam.strategy = options.overlap;
  request.beam.overlapLength = options.overlapLength;
  request.beam.fill = options.fill;
  request.beam.linearReflectivity = options.linearReflectivity;
  request.beam.sharpen = options.sharpen;
  request.beam.companions = options.companions;
  request.interpolation =
    options.motion.none ? TimeInterpolationMethod::Linear : TimeInterpolationMethod::AlongMotion;
  request.motion = options.motion.given;
  return request;
}

GridSpecification GridOf(
  const GridOptions& options, const std::vector<Position>& positions, double range)
{
  GridRequest grid = options.grid;
  grid.range = options.ownRange || grid.range != DefaultRange ? grid.range : range;
  return MakeGrid(grid, positions);
}

std::vector<Time> TimeStepsOf(
  const GridOptions& options, Time firstRay, Time lastRay, std::size_t volumes)
{
  if (options.time)
  {
    return {*options.time};
  }
  const Time first = options.begin.value_or(firstRay);
  const Time last = options.end.value_or(lastRay);
  const bool asScanned = !options.step && !options.begin && !options.end;
  if (asScanned && volumes == 1)
  {
    return {MiddleTime(first, last)};
  }
  std::vector<Time> steps = TimeSteps(first, last, options.step.value_or(DefaultStep));
  if (steps.empty() && asScanned)
  {
    return {MiddleTime(first, last)};
  }
  if (steps.empty())
  {
    throw Error("no multiple of the time step lies from " + FormatIso8601(first) + " to " +
                FormatIso8601(last) + ": set a shorter step, or other begin and end times");
  }
  return steps;
}

std::optional<TimeSpan> FindPause(const GridOptions& options, const std::vector<TimeSpan>& volumes)
{
  return options.time || (options.begin && options.end)
           ? std::nullopt
           : nexrad::FindPause(volumes, options.begin.value_or(Time::min()),
               options.end.value_or(Time::max()), LongestPause);
}

std::vector<Time> TimeStepsOf(const GridOptions& options, const SeriesScan& scan)
{
  const Time first = *scan.First();
  const Time last = *scan.Last();
  if (options.time && (*options.time < first || *options.time > last))
  {
    throw Error("--time " + FormatIso8601(*options.time) + ": the inputs hold rays from " +
                FormatIso8601(first) + " to " + FormatIso8601(last) + "; take a time from these");
  }
  const std::vector<TimeSpan> spans = scan.Spans();
  if (const std::optional<TimeSpan> pause = FindPause(options, spans))
  {
    throw Error("nothing was scanned for days, from " + FormatIso8601(pause->first) + " to " +
                FormatIso8601(pause->last) + ": say with --begin or --end what to merge");
  }
  return TimeStepsOf(options, first, last, spans.size());
}

unsigned ThreadCount()
{
  return static_cast<unsigned>(std::max(1, vtkSMPTools::GetEstimatedNumberOfThreads()));
}

} // namespace nexrad::application

// SPDX-License-Identifier: BSD-3-Clause
#include "MergeRequests.h"

#include "Temporal/VolumeSelection.h"

#include <vtkSMPTools.h>

#include <algorithm>

namespace nexrad::application
{
namespace
{

void RunRows(int count, const std::function<void(int, int)>& work)
{
  constexpr vtkIdType grain = 4; // rows cost unlike, so small shares even out
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
  series.requirePosition = true;
  series.level2.siteName = options.siteName;
  return series;
}

MergeRequest MergeRequestOf(const GridOptions& options)
{
  MergeRequest request;
  request.maximumGap = options.maximumGap;
  request.method = *ParseMergeMethod(options.method);
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

std::vector<Time> TimeStepsOf(const GridOptions& options, Time firstRay, Time lastRay)
{
  return AtLeastOneTimeStep(
    options.begin.value_or(firstRay), options.end.value_or(lastRay), options.step);
}

unsigned ThreadCount()
{
  return static_cast<unsigned>(std::max(1, vtkSMPTools::GetEstimatedNumberOfThreads()));
}

} // namespace nexrad::application

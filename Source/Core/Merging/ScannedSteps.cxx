// SPDX-License-Identifier: BSD-3-Clause
#include "nexrad/Merging/ScannedSteps.h"

#include "nexrad/System/Error.h"

namespace nexrad
{
namespace
{

SeriesOptions Shared(SeriesOptions series, const ScanShare& share)
{
  series.share = share;
  return series;
}

// An input that is damaged throughout explains why there is nothing to merge.
std::string DescribeProblems(const std::vector<InputProblem>& problems)
{
  if (problems.empty())
  {
    return {};
  }
  const std::size_t others = problems.size() - 1;
  return ": " + problems.front().Line() +
         (others > 0 ? " (and " + std::to_string(others) + " more)" : "");
}

} // namespace

ScannedSteps::ScannedSteps(const std::vector<std::filesystem::path>& inputs,
  const MergeOptions& userOptions, const RangeLoop& loop, const ScanShare& share,
  const Progress& progress)
  : options(userOptions)
  , request(MergeRequestOf(options, loop))
  , cache(options.moment, options.memory, SeriesOptionsOf(options).level2,
      SeriesOptionsOf(options).quality)
{
  const auto keep = [this](const SeriesVolume& key, const RadarVolume& volume)
  { cache.Offer(key, volume); };
  auto found = ScanInputs(inputs, Shared(SeriesOptionsOf(options), share), keep, progress);
  if (!found)
  {
    throw Error("stopped before all inputs were read");
  }
  scan = std::move(*found);
}

void ScannedSteps::Plan()
{
  if (scan.sites.empty())
  {
    throw Error("no input holds a volume that can be used" + DescribeProblems(scan.problems));
  }
  request.grid = GridOf(options, scan.Positions(), scan.Range());
  times = TimeStepsOf(options, scan);
}

std::optional<GriddedVolume> ScannedSteps::Merge(Time time, const Progress& progress)
{
  request.time = time;
  return MergeSeries(scan, cache, request, progress, &run);
}

} // namespace nexrad

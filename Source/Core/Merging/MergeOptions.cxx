// SPDX-License-Identifier: BSD-3-Clause
#include "nexrad/Merging/MergeOptions.h"

#include "nexrad/System/Error.h"

#include <algorithm>

namespace nexrad
{

MomentOptions MomentOptionsOf(const MergeRules& rules)
{
  MomentOptions options = rules;
  if (rules.method == MergeMethod::Thesis)
  {
    options.quality.level = QualityLevel::Off;
  }
  return options;
}

VolumeRule VolumeRuleOf(const MergeRules& rules)
{
  return {rules.method == MergeMethod::Thesis, rules.maximumGap};
}

void RequireMoment(MergeMethod method, MomentName moment)
{
  if (method == MergeMethod::Thesis && moment != MomentName::REF)
  {
    throw Error(
      std::string("moment ") + ToString(moment) +
      " cannot be merged by the thesis's method, which knows reflectivity alone: set REF");
  }
}

SeriesOptions SeriesOptionsOf(const MergeOptions& options)
{
  const std::vector<MomentName>& moments = options.moments;
  for (const MomentName moment : moments)
  {
    RequireMoment(options.method, moment);
    if (std::count(moments.begin(), moments.end(), moment) > 1)
    {
      throw Error(std::string("moment ") + ToString(moment) + " is named twice");
    }
  }
  SeriesOptions series;
  series.moments = moments;
  static_cast<MomentOptions&>(series) = MomentOptionsOf(options);
  series.requirePosition = true;
  series.level2.siteName = options.siteName;
  return series;
}

GridSpecification GridOf(
  const MergeOptions& options, const std::vector<Position>& positions, double range)
{
  GridRequest grid = options.grid;
  grid.range = grid.range.value_or(range);
  return MakeGrid(grid, positions);
}

std::vector<Time> TimeStepsOf(
  const MergeOptions& options, Time firstRay, Time lastRay, std::size_t volumes)
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
  if (steps.empty() && (asScanned || (options.atLeastOne && !options.begin && !options.end)))
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

std::optional<TimeSpan> FindPause(const MergeOptions& options, const std::vector<TimeSpan>& volumes)
{
  return options.time || (options.begin && options.end)
           ? std::nullopt
           : FindPause(volumes, options.begin.value_or(Time::min()),
               options.end.value_or(Time::max()), LongestPause);
}

std::vector<Time> TimeStepsOf(const MergeOptions& options, const SeriesScan& scan)
{
  const Time first = *scan.First();
  const Time last = *scan.Last();
  if (options.time && (*options.time < first || *options.time > last))
  {
    throw Error("time " + FormatIso8601(*options.time) + ": the inputs hold rays from " +
                FormatIso8601(first) + " to " + FormatIso8601(last) + "; take a time from these");
  }
  const std::vector<TimeSpan> spans = scan.Spans();
  if (const std::optional<TimeSpan> pause = FindPause(options, spans))
  {
    throw Error("nothing was scanned for days, from " + FormatIso8601(pause->first) + " to " +
                FormatIso8601(pause->last) +
                ": set where to begin or to end (--begin or --end, BeginTime or EndTime)");
  }
  return TimeStepsOf(options, first, last, spans.size());
}

} // namespace nexrad

// SPDX-License-Identifier: BSD-3-Clause
#include "nexrad/Series/VolumeSelection.h"

#include "nexrad/Motion/MotionTracker.h"
#include "nexrad/System/Error.h"

#include <algorithm>
#include <cstdint>
#include <utility>

namespace nexrad
{

std::vector<std::size_t> FindBracket(
  const std::vector<Time>& starts, Time time, Duration maximumGap)
{
  std::vector<std::size_t> bracket;
  const auto next =
    static_cast<std::size_t>(std::upper_bound(starts.begin(), starts.end(), time) - starts.begin());
  if (next > 0 && time - starts[next - 1] <= maximumGap)
  {
    bracket.push_back(next - 1);
  }
  if (next < starts.size() && starts[next] - time <= maximumGap)
  {
    bracket.push_back(next);
  }
  return bracket;
}

std::vector<std::size_t> FindVolumesAbout(
  const std::vector<Time>& starts, const std::vector<Time>& ends, Time time, Duration maximumGap)
{
  std::vector<std::size_t> about;
  const auto next =
    static_cast<std::size_t>(std::upper_bound(starts.begin(), starts.end(), time) - starts.begin());
  std::optional<std::size_t> last;       // of those that ended
  std::optional<std::size_t> beforeLast; // the one that ended before it
  for (std::size_t i = 0; i < next; ++i)
  {
    if (ends[i] > time)
    {
      about.push_back(i);
    }
    else if (!last || ends[i] >= ends[*last])
    {
      beforeLast = std::exchange(last, i);
    }
    else if (!beforeLast || ends[i] >= ends[*beforeLast])
    {
      beforeLast = i;
    }
  }
  const bool inProgress = !about.empty();
  const bool after = next < starts.size() && starts[next] - time <= maximumGap;
  const bool before = last && time - ends[*last] <= maximumGap;
  if (before)
  {
    about.push_back(*last);
    const bool pair = after && starts[next] - starts[*last] <= LongestMotionInterval;
    // A later bound would take back a volume that was not chosen at an earlier time.
    if (!inProgress && !pair && beforeLast && ends[*last] - ends[*beforeLast] <= maximumGap)
    {
      about.push_back(*beforeLast);
    }
  }
  if (after)
  {
    about.push_back(next);
    if (!inProgress && !before && next + 1 < starts.size() &&
        starts[next + 1] - starts[next] <= LongestMotionInterval)
    {
      about.push_back(next + 1);
    }
  }
  std::sort(about.begin(), about.end());
  return about;
}

std::vector<std::size_t> ChooseVolumes(
  const std::vector<Time>& starts, const std::vector<Time>& ends, Time time, const VolumeRule& rule)
{
  return rule.byNominalTimes ? FindBracket(starts, time, rule.maximumGap)
                             : FindVolumesAbout(starts, ends, time, rule.maximumGap);
}

std::vector<Time> TimeSteps(Time first, Time last, Duration step)
{
  constexpr std::int64_t mostSteps = 1'000'000;
  const std::int64_t length = step.count();
  if (length <= 0)
  {
    throw Error("time step of " + std::to_string(length) + " ms: must be longer than 0");
  }
  if (last < first)
  {
    throw Error(
      "the last time " + FormatIso8601(last) + " lies before the first " + FormatIso8601(first));
  }
  const std::int64_t begin = first.time_since_epoch().count();
  const std::int64_t end = last.time_since_epoch().count();
  // Division cuts towards zero; a step before 1970 needs the multiple above all the same.
  std::int64_t multiple = begin / length + (begin > 0 && begin % length != 0 ? 1 : 0);
  if ((end - begin) / length >= mostSteps)
  {
    throw Error("more than " + std::to_string(mostSteps) + " time steps from " +
                FormatIso8601(first) + " to " + FormatIso8601(last) + ": take a longer step");
  }
  std::vector<Time> steps;
  for (; multiple * length <= end; ++multiple)
  {
    steps.emplace_back(Duration(multiple * length));
  }
  return steps;
}

Time MiddleTime(Time first, Time last)
{
  const Time middle = first + (last - first) / 2;
  return std::max(first, Time(std::chrono::floor<std::chrono::seconds>(middle)));
}

std::optional<TimeSpan> FindPause(
  std::vector<TimeSpan> volumes, Time begin, Time end, Duration longest)
{
  const auto outside = [begin, end](const TimeSpan& volume)
  { return volume.last < begin || volume.first > end; };
  volumes.erase(std::remove_if(volumes.begin(), volumes.end(), outside), volumes.end());
  std::sort(volumes.begin(), volumes.end(),
    [](const TimeSpan& a, const TimeSpan& b) { return a.first < b.first; });
  for (std::size_t i = 1; i < volumes.size(); ++i)
  {
    const Time last = volumes[i - 1].last;
    if (volumes[i].first - last > longest)
    {
      return TimeSpan{last, volumes[i].first};
    }
    volumes[i].last = std::max(volumes[i].last, last);
  }
  return std::nullopt;
}

} // namespace nexrad

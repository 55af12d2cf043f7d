// SPDX-License-Identifier: BSD-3-Clause
#include "nexrad/Level2/RayTimes.h"

#include <algorithm>
#include <chrono>
#include <vector>

namespace nexrad
{

namespace
{

constexpr Duration widestGap = std::chrono::hours(1);
constexpr Duration longestFile = std::chrono::hours(24);
constexpr std::size_t fewestRays = 30;

// Times between which no gap is wider than an hour.
struct TimeGroup
{
  Time first;
  Time last;
  Time middle; // of the rays' times
  std::size_t rays;
};

std::vector<TimeGroup> GroupTimes(std::vector<Time> times)
{
  std::sort(times.begin(), times.end());
  std::vector<TimeGroup> groups;
  for (std::size_t begin = 0; begin < times.size();)
  {
    std::size_t end = begin + 1;
    while (end < times.size() && times[end] - times[end - 1] <= widestGap)
    {
      ++end;
    }
    groups.push_back({times[begin], times[end - 1], times[(begin + end) / 2], end - begin});
    begin = end;
  }
  return groups;
}

TimeGroup FindLargest(const std::vector<TimeGroup>& groups, std::optional<Time> headerTime)
{
  const auto isSmaller = [&headerTime](const TimeGroup& a, const TimeGroup& b)
  {
    if (a.rays != b.rays || !headerTime)
    {
      return a.rays < b.rays;
    }
    return std::chrono::abs(a.middle - *headerTime) > std::chrono::abs(b.middle - *headerTime);
  };
  return *std::max_element(groups.begin(), groups.end(), isSmaller);
}

// The groups whose times are believed.
std::vector<TimeGroup> ChooseGroups(const RadarVolume& volume, std::vector<Time> times)
{
  const std::vector<TimeGroup> groups = GroupTimes(std::move(times));
  const TimeGroup largest = FindLargest(groups, volume.headerTime);
  std::vector<TimeGroup> right;
  for (TimeGroup group : groups)
  {
    const bool isLargest = group.first == largest.first;
    // A group of a few rays at each hour may go on for years.
    group.first = std::max(group.first, largest.middle - longestFile);
    group.last = std::min(group.last, largest.middle + longestFile);
    if (isLargest || (group.rays >= fewestRays && group.first <= group.last))
    {
      right.push_back(group);
    }
  }
  return right;
}

std::vector<Time> TimesOf(const RadarVolume& volume)
{
  std::vector<Time> times;
  for (const Sweep& sweep : volume.sweeps)
  {
    for (const Ray& ray : sweep.rays)
    {
      times.push_back(ray.time);
    }
  }
  return times;
}

bool IsWithin(Time time, const std::vector<TimeGroup>& groups)
{
  return std::any_of(groups.begin(), groups.end(),
    [time](const TimeGroup& group) { return time >= group.first && time <= group.last; });
}

// The first time that is right.
Time FirstRight(const std::vector<Time>& times, const std::vector<TimeGroup>& groups)
{
  return *std::find_if(
    times.begin(), times.end(), [&groups](Time time) { return IsWithin(time, groups); });
}

} // namespace

void MendRayTimes(RadarVolume& volume, const RayDamageReceiver& report)
{
  const std::vector<Time> times = TimesOf(volume);
  const auto extremes = std::minmax_element(times.begin(), times.end());
  if (times.empty() || *extremes.second - *extremes.first <= widestGap)
  {
    return;
  }
  const std::vector<TimeGroup> groups = ChooseGroups(volume, times);
  Time last = FirstRight(times, groups);
  for (std::size_t index = 0; index < volume.sweeps.size(); ++index)
  {
    std::vector<Ray>& rays = volume.sweeps[index].rays;
    for (std::size_t ray = 0; ray < rays.size(); ++ray)
    {
      if (!IsWithin(rays[ray].time, groups))
      {
        report(index, ray,
          "a ray of " + FormatIso8601(rays[ray].time) +
            ", hours from the other rays of the file; it is taken for one of " +
            FormatIso8601(last));
        rays[ray].time = last;
      }
      last = rays[ray].time;
    }
  }
}

} // namespace nexrad

// SPDX-License-Identifier: BSD-3-Clause
#include "Temporal/VolumeSelection.h"

#include "Model/Error.h"

#include <algorithm>
#include <cstdint>
#include <iterator>

namespace nexrad
{

VolumeBracket FindBracket(const std::vector<Time>& starts, Time time, Duration maximumGap)
{
  VolumeBracket bracket;
  const auto next = std::upper_bound(starts.begin(), starts.end(), time);
  if (next != starts.begin() && time - *std::prev(next) <= maximumGap)
  {
    bracket.before = static_cast<std::size_t>(std::distance(starts.begin(), next)) - 1;
  }
  if (next != starts.end() && *next - time <= maximumGap)
  {
    bracket.after = static_cast<std::size_t>(std::distance(starts.begin(), next));
  }
  return bracket;
}

std::vector<std::size_t> FindVolumesAbout(
  const std::vector<Time>& starts, const std::vector<Time>& ends, Time time, Duration maximumGap)
{
  std::vector<std::size_t> about;
  const auto next = static_cast<std::size_t>(
    std::distance(starts.begin(), std::upper_bound(starts.begin(), starts.end(), time)));
  std::optional<std::size_t> lastEnded;
  for (std::size_t i = 0; i < next; ++i)
  {
    if (ends[i] > time)
    {
      about.push_back(i);
    }
    else if (!lastEnded || ends[i] >= ends[*lastEnded])
    {
      lastEnded = i;
    }
  }
  if (lastEnded && time - ends[*lastEnded] <= maximumGap)
  {
    about.push_back(*lastEnded);
  }
  if (next < starts.size() && starts[next] - time <= maximumGap)
  {
    about.push_back(next);
  }
  std::sort(about.begin(), about.end());
  return about;
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

std::vector<Time> AtLeastOneTimeStep(Time first, Time last, Duration step)
{
  std::vector<Time> steps = TimeSteps(first, last, step);
  if (steps.empty())
  {
    throw Error("no multiple of the time step lies from " + FormatIso8601(first) + " to " +
                FormatIso8601(last) + ": set a shorter step, or other begin and end times");
  }
  return steps;
}

} // namespace nexrad

// SPDX-License-Identifier: BSD-3-Clause
#include "nexrad/Level2/Assembly/RayClock.h"

#include "nexrad/Level2/Assembly/RayStretches.h"

#include <chrono>

namespace nexrad
{

namespace
{

constexpr std::size_t mostInARow = 10;

void MoveTimes(const RayList& rays, const RayStretch& stretch, Duration by)
{
  for (std::size_t i = stretch.begin; i < stretch.end; ++i)
  {
    rays[i]->ray.time += by;
  }
}

// Few rays whose neighbours in the file follow each other in time.
bool MendFew(const RayList& rays, const std::vector<RayStretch>& stretches, std::size_t index,
  const ArrivedDamage& report)
{
  const RayStretch& stretch = stretches[index];
  if (index == 0 || index + 1 == stretches.size() || stretch.Size() > mostInARow)
  {
    return false;
  }
  const ArrivedRay& before = *rays[stretch.begin - 1];
  const ArrivedRay& after = *rays[stretch.end];
  const ArrivedRay& first = *rays[stretch.begin];
  if (IsScannedBefore(after, before) || after.ray.time - before.ray.time > LongestStep ||
      !BelongsBetween(&before, first, *rays[stretch.end - 1], &after))
  {
    return false;
  }
  report(first, CountRays(stretch.Size()) + " from " + FormatIso8601(first.ray.time) +
                  " on, out of the time of the rays beside them; taken for " +
                  FormatIso8601(before.ray.time));
  for (std::size_t i = stretch.begin; i < stretch.end; ++i)
  {
    rays[i]->ray.time = before.ray.time;
  }
  return true;
}

// Where cuts and numbers go on from one stretch to the next, and the clock goes back.
void MendStep(const RayList& rays, const RayStretch& after, const ArrivedDamage& report,
  std::vector<std::string>& notes)
{
  const ArrivedRay& last = *rays[after.begin - 1];
  const ArrivedRay& first = *rays[after.begin];
  const Duration step = last.ray.time - first.ray.time;
  if (step <= Duration(0) || !IsNext(last, first))
  {
    return;
  }
  const std::size_t behind = rays.size() - after.begin;
  const bool moveBehind = behind <= after.begin;
  const std::string what = "the clock goes back by " + std::to_string(step.count()) + " ms at " +
                           FormatIso8601(last.ray.time) + "; the " +
                           CountRays(moveBehind ? behind : after.begin) +
                           (moveBehind ? " behind that" : " before that") + " are moved";
  if (step > LongestStep)
  {
    report(first, what);
  }
  else
  {
    notes.push_back(what);
  }
  MoveTimes(rays, moveBehind ? RayStretch{after.begin, rays.size()} : RayStretch{0, after.begin},
    moveBehind ? step : -step);
}

} // namespace

void MendClock(const RayList& rays, const ArrivedDamage& report, std::vector<std::string>& notes)
{
  const std::vector<RayStretch> stretches = CutStretches(rays);
  if (stretches.size() < 2)
  {
    return;
  }
  const ScanPlaces places(rays);
  std::vector<RayStretch> kept; // those that few wrong times do not cut any more
  for (std::size_t i = 0; i < stretches.size(); ++i)
  {
    const bool fits = places.Fit(rays, stretches[i]);
    if (!fits && !MendFew(rays, stretches, i, report))
    {
      kept.push_back(stretches[i]);
    }
  }
  for (const RayStretch& stretch : kept)
  {
    if (stretch.begin > 0)
    {
      MendStep(rays, stretch, report, notes);
    }
  }
}

} // namespace nexrad

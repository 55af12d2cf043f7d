// SPDX-License-Identifier: BSD-3-Clause
#include "nexrad/Level2/Assembly/RayDates.h"

#include "nexrad/System/MessageText.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstddef>
#include <unordered_map>
#include <utility>

namespace nexrad
{

namespace
{

// Rays of a list that stand one behind the other.
struct RayStretch
{
  std::size_t Size() const { return end - begin; }

  std::size_t begin = 0; // the first ray
  std::size_t end = 0;   // behind the last ray
};

bool AreNear(const ArrivedRay& before, const ArrivedRay& after)
{
  return after.ray.time - before.ray.time <= LongestStep;
}

// Cuts a list where the time goes back, or on by more than LongestStep.
std::vector<RayStretch> CutStretches(const RayList& rays)
{
  std::vector<RayStretch> stretches;
  for (std::size_t i = 0; i < rays.size(); ++i)
  {
    const bool goesOn =
      i > 0 && !IsScannedBefore(*rays[i], *rays[i - 1]) && AreNear(*rays[i - 1], *rays[i]);
    if (!goesOn)
    {
      stretches.push_back({i, i});
    }
    stretches.back().end = i + 1;
  }
  return stretches;
}

// The places that the rays of a list have in the order scanned.
class ScanPlaces
{
public:
  explicit ScanPlaces(const RayList& rays)
    : ordered(rays)
  {
    std::stable_sort(ordered.begin(), ordered.end(),
      [](const ArrivedRay* a, const ArrivedRay* b) { return IsScannedBefore(*a, *b); });
    for (std::size_t i = 0; i < ordered.size(); ++i)
    {
      places[ordered[i]] = i;
    }
  }

  // True when a stretch of the list may stand where its times are: no other ray is between its
  // rays, and their cuts and numbers go on from the ray before to the ray behind them, one of them
  // without a loss or both within LongestStep.
  bool Fit(const RayList& rays, const RayStretch& stretch) const
  {
    const ArrivedRay& first = *rays[stretch.begin];
    const ArrivedRay& last = *rays[stretch.end - 1];
    const std::size_t place = places.at(&first);
    const std::size_t end = place + stretch.Size();
    if (places.at(&last) + 1 != end)
    {
      return false;
    }
    const ArrivedRay* before = place > 0 ? ordered[place - 1] : nullptr;
    const ArrivedRay* after = end < ordered.size() ? ordered[end] : nullptr;
    const bool nearBefore = before != nullptr && AreNear(*before, first);
    const bool nearAfter = after != nullptr && AreNear(last, *after);
    const bool mayFollow = before == nullptr || MayFollow(*before, first);
    const bool mayGoOn = after == nullptr || MayFollow(last, *after);
    const bool isNext =
      (nearBefore && IsNext(*before, first)) || (nearAfter && IsNext(last, *after));
    return mayFollow && mayGoOn && (isNext || (nearBefore && nearAfter));
  }

private:
  RayList ordered;
  std::unordered_map<const ArrivedRay*, std::size_t> places; // in `ordered`
};

constexpr std::size_t mostInARow = 10; // rays that get the time of a neighbour

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
  report(first, CountText(stretch.Size(), "ray") + " from " + FormatIso8601(first.ray.time) +
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
                           CountText(moveBehind ? behind : after.begin, "ray") +
                           (moveBehind ? " behind that" : " before that") + " are moved";
  if (step > LongestStep)
  {
    report(first, what);
  }
  else
  {
    notes.push_back(what);
  }
  const auto from = rays.begin() + static_cast<std::ptrdiff_t>(after.begin);
  std::for_each(moveBehind ? from : rays.begin(), moveBehind ? rays.end() : from,
    [by = moveBehind ? step : -step](ArrivedRay* ray) { ray->ray.time += by; });
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

namespace
{

constexpr Duration widestGap = std::chrono::hours(1);
constexpr Duration day = std::chrono::hours(24);

// Midnight before the first ray of `after`, when that goes on from `before` in the file but for its
// date, which is still the old one.
std::optional<Time> FindOldDate(
  const RayList& rays, const RayStretch& before, const RayStretch& after)
{
  constexpr Duration longestPause = std::chrono::minutes(10);
  constexpr std::size_t fewestRays = 10; // fewer may have a wrong date
  const Time last = rays[before.end - 1]->ray.time;
  const Time first = rays[after.begin]->ray.time;
  const Duration pause = first + day - last;
  const Time midnight(first.time_since_epoch() / day * day);
  const bool goesOn = pause >= Duration(0) && pause <= longestPause && last < midnight + day &&
                      before.Size() >= fewestRays && after.Size() >= fewestRays &&
                      MayFollow(*rays[before.end - 1], *rays[after.begin]);
  return goesOn ? std::optional(midnight) : std::nullopt;
}

void GoOnAtMidnight(const RayList& rays, std::vector<std::string>& notes)
{
  const std::vector<RayStretch> stretches = CutStretches(rays);
  std::optional<Time> oldDate;
  for (std::size_t i = 1; i < stretches.size() && !oldDate; ++i)
  {
    oldDate = FindOldDate(rays, stretches[i - 1], stretches[i]);
  }
  std::size_t mended = 0;
  for (ArrivedRay* ray : rays)
  {
    if (oldDate && ray->ray.time >= *oldDate && ray->ray.time < *oldDate + day / 2)
    {
      ray->ray.time += day;
      ++mended;
    }
  }
  if (mended > 0)
  {
    notes.push_back("the date does not go on at midnight: " + CountText(mended, "ray") +
                    " get the date of the next day");
  }
}

// Whole days, rounded.
Duration::rep DaysBetween(Time from, Time to)
{
  return static_cast<Duration::rep>(
    std::llround(static_cast<double>((to - from).count()) / static_cast<double>(day.count())));
}

// Times between which no gap is wider than an hour.
struct TimeGroup
{
  bool Has(Time time) const { return time >= first && time <= last; }

  Time first;
  Time last;
  Time middle; // of the rays' times
  std::size_t rays = 0;
};

std::vector<TimeGroup> GroupTimes(const RayList& rays)
{
  std::vector<Time> times;
  for (const ArrivedRay* ray : rays)
  {
    times.push_back(ray->ray.time);
  }
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

// The group that is right: of the header's time, when it has a tenth of the rays, or of most rays.
TimeGroup FindLargest(
  const std::vector<TimeGroup>& groups, std::size_t rays, std::optional<Time> headerTime)
{
  constexpr std::size_t share = 10;
  const auto distance = [&headerTime](const TimeGroup& group)
  { return headerTime ? std::chrono::abs(group.middle - *headerTime) : Duration(0); };
  const auto isOfHeader = [&](const TimeGroup& group)
  { return headerTime && distance(group) <= widestGap && group.rays * share >= rays; };
  const auto isSmaller = [&](const TimeGroup& a, const TimeGroup& b)
  {
    if (isOfHeader(a) != isOfHeader(b))
    {
      return isOfHeader(b);
    }
    return a.rays != b.rays ? a.rays < b.rays : distance(a) > distance(b);
  };
  return *std::max_element(groups.begin(), groups.end(), isSmaller);
}

// Rays of a group, by their places in the file.
struct GroupPlaces
{
  std::size_t first = 0;
  std::size_t last = 0;
  bool startsVolume = false;
};

GroupPlaces PlacesOf(const RayList& rays, const TimeGroup& group)
{
  GroupPlaces places;
  places.first = rays.size();
  for (std::size_t i = 0; i < rays.size(); ++i)
  {
    if (group.Has(rays[i]->ray.time))
    {
      places.first = std::min(places.first, i);
      places.last = i;
      places.startsVolume =
        places.startsVolume || rays[i]->ray.radialStatus == RadialStatus::StartOfVolume;
    }
  }
  return places;
}

// Whether a group is a volume of its own, before or behind the largest one.
bool IsOwnVolume(const RayList& rays, const TimeGroup& group, const TimeGroup& largest)
{
  constexpr std::size_t fewestRays = 30;
  constexpr std::size_t raysOfCut = 300; // a start may be lost
  if (group.rays < fewestRays || group.first < largest.middle - day ||
      group.last > largest.middle + day)
  {
    return false;
  }
  const GroupPlaces own = PlacesOf(rays, group);
  const GroupPlaces others = PlacesOf(rays, largest);
  const bool inOrder =
    group.first < largest.first ? own.last < others.first : own.first > others.last;
  return inOrder && (own.startsVolume || group.rays >= raysOfCut);
}

// The rays of a file whose times are right, and how the others become right.
class RightTimes
{
public:
  RightTimes(const RayList& theRays, std::optional<Time> headerTime, const ArrivedDamage& theReport)
    : rays(theRays)
    , report(theReport)
    , isRight(theRays.size())
  {
    const std::vector<TimeGroup> groups = GroupTimes(rays);
    const TimeGroup largest = FindLargest(groups, rays.size(), headerTime);
    std::size_t examined = 0;
    for (const TimeGroup& group : groups)
    {
      constexpr std::size_t mostGroups = 100; // each is looked for in all rays
      const bool isLargest = group.first == largest.first;
      if (isLargest || (++examined <= mostGroups && IsOwnVolume(rays, group, largest)))
      {
        this->Accept(group);
      }
    }
  }

  // Goes from the first to the last ray, and then back, so that rays that were mended help others.
  void Mend()
  {
    const std::vector<RayStretch> stretches = CutStretches(rays);
    std::vector<ArrivedRay*> next(stretches.size()); // the first right ray behind each
    for (std::size_t i = stretches.size() - 1; i > 0; --i)
    {
      next[i - 1] = isRight[stretches[i].begin] ? rays[stretches[i].begin] : next[i];
    }
    const ArrivedRay* before = nullptr;
    for (std::size_t i = 0; i < stretches.size(); ++i)
    {
      const bool right =
        isRight[stretches[i].begin] || this->MendOne(before, stretches[i], next[i]);
      before = right ? rays[stretches[i].end - 1] : before;
    }
    const ArrivedRay* after = nullptr;
    for (auto stretch = stretches.rbegin(); stretch != stretches.rend(); ++stretch)
    {
      const bool right = isRight[stretch->begin] || this->MendOne(nullptr, *stretch, after);
      after = right ? rays[stretch->begin] : after;
    }
  }

  bool IsRight(std::size_t index) const { return isRight[index]; }

private:
  void Accept(const TimeGroup& group)
  {
    for (std::size_t i = 0; i < rays.size(); ++i)
    {
      isRight[i] = isRight[i] || group.Has(rays[i]->ray.time);
    }
  }

  bool MendOne(const ArrivedRay* before, const RayStretch& stretch, const ArrivedRay* after)
  {
    const ArrivedRay& first = *rays[stretch.begin];
    const ArrivedRay& last = *rays[stretch.end - 1];
    return BelongsBetween(before, first, last, after) &&
           (before != nullptr ? this->MoveBeside(stretch, first.ray.time, before->ray.time)
                              : this->MoveBeside(stretch, last.ray.time, after->ray.time));
  }

  // `nearest` is the time of the stretch's ray that is next to a right one, at `beside`.
  bool MoveBeside(const RayStretch& stretch, Time nearest, Time beside)
  {
    const Duration shift = DaysBetween(nearest, beside) * day;
    const bool dayFits = std::chrono::abs(nearest + shift - beside) <= LongestStep;
    if (!dayFits && stretch.Size() >= mostInARow)
    {
      return false;
    }
    const ArrivedRay& first = *rays[stretch.begin];
    const Time old = first.ray.time;
    for (std::size_t i = stretch.begin; i < stretch.end; ++i)
    {
      Time& time = rays[i]->ray.time;
      time = dayFits ? time + shift : beside;
      isRight[i] = true;
    }
    report(first, (stretch.Size() == 1 ? "a ray" : CountText(stretch.Size(), "ray")) +
                    std::string(" of ") + FormatIso8601(old) +
                    ", hours from the other rays of the file; taken for " +
                    FormatIso8601(first.ray.time));
    return true;
  }

  const RayList& rays;
  const ArrivedDamage& report;
  std::vector<bool> isRight;
};

} // namespace

void MendDates(RayList& rays, std::optional<Time> headerTime, const ArrivedDamage& report,
  std::vector<std::string>& notes)
{
  const auto extremes = std::minmax_element(rays.begin(), rays.end(),
    [](const ArrivedRay* a, const ArrivedRay* b) { return a->ray.time < b->ray.time; });
  if (rays.empty() || (*extremes.second)->ray.time - (*extremes.first)->ray.time <= widestGap)
  {
    return;
  }
  GoOnAtMidnight(rays, notes);
  RightTimes times(rays, headerTime, report);
  times.Mend();
  RayList right;
  RayList leftOut;
  for (std::size_t i = 0; i < rays.size(); ++i)
  {
    (times.IsRight(i) ? right : leftOut).push_back(rays[i]);
  }
  if (!leftOut.empty())
  {
    report(*leftOut.front(), CountText(leftOut.size(), "ray") + " of " +
                               FormatIso8601(leftOut.front()->ray.time) +
                               (leftOut.size() == 1 ? "" : " and other times") +
                               ", an hour or more from the other rays of the file: left out");
  }
  rays = std::move(right);
}

} // namespace nexrad

// SPDX-License-Identifier: BSD-3-Clause
#include "nexrad/Level2/Assembly/RayOrder.h"

#include "nexrad/Level2/Assembly/RayDates.h"
#include "nexrad/System/MessageText.h"

#include <algorithm>
#include <chrono>
#include <tuple>
#include <unordered_set>
#include <utility>

namespace nexrad
{

namespace
{

// What two copies of one ray have in common.
auto IdentityOf(const ArrivedRay& ray)
{
  return std::tie(ray.ray.time, ray.ray.elevationNumber, ray.azimuthNumber, ray.ray.azimuth);
}

bool AreTheSame(const ArrivedRay& a, const ArrivedRay& b)
{
  return IdentityOf(a) == IdentityOf(b);
}

bool AreInOrder(const ArrivedRay* a, const ArrivedRay* b)
{
  return IsScannedBefore(*a, *b);
}

bool GoesOn(const ArrivedRay& before, const ArrivedRay& after)
{
  return !IsScannedBefore(after, before) && !AreTheSame(before, after) &&
         (before.ray.elevationNumber != after.ray.elevationNumber || StartsCut(after.ray) ||
           after.azimuthNumber > before.azimuthNumber || after.azimuthNumber == 0);
}

// Whether nothing has to be done.
bool IsInOrder(const RayList& rays)
{
  constexpr Duration longestVolume = std::chrono::hours(1);
  for (std::size_t i = 1; i < rays.size(); ++i)
  {
    if (!GoesOn(*rays[i - 1], *rays[i]))
    {
      return false;
    }
  }
  return rays.empty() || rays.back()->ray.time - rays.front()->ray.time <= longestVolume;
}

std::size_t GatesOf(const ArrivedRay& ray)
{
  std::size_t gates = 0;
  for (const MomentRow& row : ray.ray.moments)
  {
    gates += row.gates;
  }
  return gates;
}

void Remove(const std::unordered_set<const ArrivedRay*>& some, RayList& rays)
{
  const auto isOne = [&some](const ArrivedRay* ray) { return some.count(ray) > 0; };
  rays.erase(std::remove_if(rays.begin(), rays.end(), isOne), rays.end());
}

void RemoveRepeated(RayList& rays, std::vector<std::string>& notes)
{
  RayList sorted = rays;
  std::stable_sort(sorted.begin(), sorted.end(),
    [](const ArrivedRay* a, const ArrivedRay* b) { return IdentityOf(*a) < IdentityOf(*b); });
  std::unordered_set<const ArrivedRay*> repeated;
  const ArrivedRay* kept = nullptr;
  for (const ArrivedRay* ray : sorted)
  {
    const bool comesAgain = kept != nullptr && AreTheSame(*kept, *ray);
    const bool isBetter = comesAgain && GatesOf(*ray) > GatesOf(*kept);
    if (comesAgain)
    {
      repeated.insert(isBetter ? kept : ray);
    }
    kept = !comesAgain || isBetter ? ray : kept;
  }
  if (!repeated.empty())
  {
    Remove(repeated, rays);
    notes.push_back(CountText(repeated.size(), "ray") +
                    (repeated.size() == 1 ? " comes" : " come") +
                    " more than once in the file, and each counts once");
  }
}

// How many rays have to be moved to bring a list into the order scanned: all but those of the
// longest part of it that is in order.
std::size_t CountMisplaced(const RayList& rays)
{
  RayList ends; // the ray that ends the part in order of each length
  for (ArrivedRay* ray : rays)
  {
    const auto longer = std::upper_bound(ends.begin(), ends.end(), ray, AreInOrder);
    if (longer == ends.end())
    {
      ends.push_back(ray);
    }
    else
    {
      *longer = ray;
    }
  }
  return rays.size() - ends.size();
}

// Rays that are not the next by number to the ray before them.
std::size_t CountBreaks(const RayList& rays)
{
  std::size_t breaks = 0;
  for (std::size_t i = 1; i < rays.size(); ++i)
  {
    breaks += IsNext(*rays[i - 1], *rays[i]) ? 0 : 1;
  }
  return breaks;
}

// Rays of one cut whose numbers go on, possibly with rays of others between them.
using Chain = RayList;

// How far the time between two rays of a cut is from what their numbers say.
std::optional<Duration> StrainOf(const ArrivedRay& before, const ArrivedRay& after)
{
  constexpr Duration usualStep = std::chrono::milliseconds(50); // 30 to 100 ms in the test data
  const Duration pause = after.ray.time - before.ray.time;
  if (before.ray.elevationNumber != after.ray.elevationNumber || StartsCut(after.ray) ||
      before.azimuthNumber >= after.azimuthNumber || pause > LongestStep)
  {
    return std::nullopt;
  }
  return std::chrono::abs(pause - usualStep * (after.azimuthNumber - before.azimuthNumber));
}

// The chains of rays that are in the order scanned.
std::vector<Chain> FindChains(const RayList& rays)
{
  constexpr std::size_t mostOpen = 4; // chains that a ray may belong to
  std::vector<Chain> chains;
  for (ArrivedRay* ray : rays)
  {
    std::optional<std::size_t> own;
    Duration least = Duration::max();
    for (std::size_t i = chains.size() - std::min(chains.size(), mostOpen); i < chains.size(); ++i)
    {
      const std::optional<Duration> strain = StrainOf(*chains[i].back(), *ray);
      if (strain && *strain <= least)
      {
        own = i;
        least = *strain;
      }
    }
    if (!own)
    {
      own = chains.size();
      chains.emplace_back();
    }
    chains[*own].push_back(ray);
  }
  return chains;
}

// Of two chains whose times overlap, the one with more rays is the antenna's.
std::vector<Chain> FindIntruders(std::vector<Chain> chains)
{
  constexpr std::size_t fewestRays = 10; // fewer may be rays of a wrong number
  std::vector<Chain> intruders;
  Chain kept; // the last one at the time
  for (Chain& chain : chains)
  {
    if (chain.size() < fewestRays)
    {
      continue;
    }
    if (kept.empty() || kept.back()->ray.time <= chain.front()->ray.time)
    {
      kept = std::move(chain);
      continue;
    }
    if (chain.size() > kept.size())
    {
      std::swap(chain, kept);
    }
    intruders.push_back(std::move(chain));
  }
  return intruders;
}

// Takes out the rays of a cut at the time of another. Where they are many, it is the times that
// are wrong, and all stay.
void RemoveIntruders(RayList& sorted, RayList& rays, const ArrivedDamage& report)
{
  constexpr std::size_t share = 10;
  const std::vector<Chain> chains = FindIntruders(FindChains(sorted));
  std::unordered_set<const ArrivedRay*> intruders;
  for (const Chain& chain : chains)
  {
    intruders.insert(chain.begin(), chain.end());
  }
  if (!intruders.empty() && intruders.size() * share <= rays.size())
  {
    report(*chains.front().front(),
      CountText(intruders.size(), "ray") + " at the time of another cut with more rays: left out");
    Remove(intruders, sorted);
    Remove(intruders, rays);
  }
}

// Brings the rays into the order scanned, unless their cuts and numbers go on better as they are:
// then it is their times that are wrong.
void SortRays(RayList& rays, std::vector<std::string>& notes, const ArrivedDamage& report)
{
  RayList sorted = rays;
  std::stable_sort(sorted.begin(), sorted.end(), AreInOrder);
  RemoveIntruders(sorted, rays, report);
  const std::size_t misplaced = CountMisplaced(rays);
  if (misplaced > 0 && CountBreaks(sorted) <= CountBreaks(rays))
  {
    rays = std::move(sorted);
    notes.push_back(CountText(misplaced, "ray") + (misplaced == 1 ? " is" : " are") +
                    " out of order in the file, and put where time, cut and number say");
  }
}

} // namespace

void OrderRays(RayList& rays, std::optional<Time> headerTime, const ArrivedDamage& report,
  std::vector<std::string>& notes)
{
  if (IsInOrder(rays))
  {
    return;
  }
  RemoveRepeated(rays, notes);
  MendDates(rays, headerTime, report, notes);
  MendClock(rays, report, notes);
  SortRays(rays, notes, report);
}

} // namespace nexrad

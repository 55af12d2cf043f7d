// SPDX-License-Identifier: BSD-3-Clause
#include "nexrad/Level2/Assembly/ArrivedRay.h"

#include <algorithm>
#include <tuple>

namespace nexrad
{

namespace
{

bool AreOfOneCut(const ArrivedRay& a, const ArrivedRay& b)
{
  return a.ray.elevationNumber == b.ray.elevationNumber;
}

} // namespace

bool StartsCut(const Ray& ray)
{
  return ray.radialStatus == RadialStatus::StartOfCut ||
         ray.radialStatus == RadialStatus::StartOfVolume ||
         ray.radialStatus == RadialStatus::StartOfLastCut;
}

bool IsNext(const ArrivedRay& before, const ArrivedRay& after)
{
  if (AreOfOneCut(before, after))
  {
    return after.azimuthNumber == before.azimuthNumber + 1;
  }
  return after.ray.elevationNumber == before.ray.elevationNumber + 1 && StartsCut(after.ray) &&
         after.azimuthNumber <= 1;
}

bool MayFollow(const ArrivedRay& before, const ArrivedRay& after)
{
  return StartsCut(after.ray) ||
         (AreOfOneCut(before, after) ? after.azimuthNumber > before.azimuthNumber
                                     : after.ray.elevationNumber > before.ray.elevationNumber);
}

bool BelongsBetween(const ArrivedRay* before, const ArrivedRay& first, const ArrivedRay& last,
  const ArrivedRay* after)
{
  if (before == nullptr || after == nullptr)
  {
    return before != nullptr ? IsNext(*before, first) : after != nullptr && IsNext(last, *after);
  }
  const bool ofFormer = AreOfOneCut(*before, first);
  const bool ofLatter = AreOfOneCut(last, *after);
  return (ofFormer || ofLatter) && (!ofFormer || first.azimuthNumber > before->azimuthNumber) &&
         (!ofLatter || last.azimuthNumber < after->azimuthNumber) &&
         (ofFormer || StartsCut(first.ray) ||
           first.ray.elevationNumber > before->ray.elevationNumber) &&
         (ofLatter || MayFollow(last, *after));
}

std::string CountRays(std::size_t count)
{
  return std::to_string(count) + (count == 1 ? " ray" : " rays");
}

namespace
{

bool AreNear(const ArrivedRay& before, const ArrivedRay& after)
{
  return after.ray.time - before.ray.time <= LongestStep;
}

} // namespace

bool IsScannedBefore(const ArrivedRay& a, const ArrivedRay& b)
{
  return std::tie(a.ray.time, a.ray.elevationNumber, a.azimuthNumber) <
         std::tie(b.ray.time, b.ray.elevationNumber, b.azimuthNumber);
}

std::vector<RayStretch> CutStretches(const RayList& rays)
{
  std::vector<RayStretch> stretches;
  for (std::size_t i = 0; i < rays.size(); ++i)
  {
    const bool goesOn = i > 0 && !IsScannedBefore(*rays[i], *rays[i - 1]) &&
                        rays[i]->ray.time - rays[i - 1]->ray.time <= LongestStep;
    if (!goesOn)
    {
      stretches.push_back({i, i});
    }
    stretches.back().end = i + 1;
  }
  return stretches;
}

ScanPlaces::ScanPlaces(const RayList& rays)
  : ordered(rays)
{
  std::stable_sort(ordered.begin(), ordered.end(),
    [](const ArrivedRay* a, const ArrivedRay* b) { return IsScannedBefore(*a, *b); });
  for (std::size_t i = 0; i < ordered.size(); ++i)
  {
    places[ordered[i]] = i;
  }
}

bool ScanPlaces::Fit(const RayList& rays, const RayStretch& stretch) const
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
  const bool isNext = (nearBefore && IsNext(*before, first)) || (nearAfter && IsNext(last, *after));
  return mayFollow && mayGoOn && (isNext || (nearBefore && nearAfter));
}

} // namespace nexrad

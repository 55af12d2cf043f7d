// SPDX-License-Identifier: BSD-3-Clause
#include "nexrad/Level2/Assembly/ArrivedRay.h"

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

bool IsScannedBefore(const ArrivedRay& a, const ArrivedRay& b)
{
  return std::tie(a.ray.time, a.ray.elevationNumber, a.azimuthNumber) <
         std::tie(b.ray.time, b.ray.elevationNumber, b.azimuthNumber);
}

} // namespace nexrad

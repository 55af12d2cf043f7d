// SPDX-License-Identifier: BSD-3-Clause
#include "nexrad/Level2/Assembly/SweepWatch.h"

#include <cmath>
#include <cstdio>

namespace nexrad
{

namespace
{

} // namespace

double SweepWatch::TurnTo(float azimuth) const
{
  // The remainder lies within -180 and 180 degrees: the antenna goes the short way between rays.
  return last == nullptr ? 0.0
                         : turned + std::remainder(static_cast<double>(azimuth) -
                                                     static_cast<double>(last->ray.azimuth),
                                      360.0);
}

void SweepWatch::Add(const ArrivedRay& arrived)
{
  const Ray& ray = arrived.ray;
  const unsigned number = arrived.azimuthNumber;
  if (last == nullptr && number > 1 && !StartsCut(ray))
  {
    this->Count(number - 1, ray.azimuth, arrived);
  }
  else if (last != nullptr && number > last->azimuthNumber + 1)
  {
    this->Count(number - last->azimuthNumber - 1, last->ray.azimuth, arrived);
  }
  turned = this->TurnTo(ray.azimuth);
  first = first != nullptr ? first : &arrived;
  last = &arrived;
}

void SweepWatch::Count(std::size_t lost, float from, const ArrivedRay& behind)
{
  if (gaps == 0)
  {
    gapFrom = from;
    gapTo = behind.ray.azimuth;
    behindGap = &behind;
  }
  missing += lost;
  ++gaps;
}

bool SweepWatch::IsCutOff() const
{
  constexpr double almostFull = 358.0; // a full turn less one ray at each end
  return last != nullptr && last->ray.radialStatus != RadialStatus::EndOfCut &&
         last->ray.radialStatus != RadialStatus::EndOfVolume && std::abs(turned) < almostFull;
}

std::string SweepWatch::Describe(std::size_t sweepIndex, int elevationNumber) const
{
  if (missing == 0)
  {
    return {};
  }
  char place[96];
  if (gapFrom == gapTo)
  {
    std::snprintf(place, sizeof place, "before azimuth %.2f degrees", double(gapTo));
  }
  else
  {
    std::snprintf(
      place, sizeof place, "between azimuth %.2f and %.2f degrees", double(gapFrom), double(gapTo));
  }
  return std::to_string(missing) + (missing == 1 ? " ray" : " rays") + " missing in sweep " +
         std::to_string(sweepIndex) + " (elevation number " + std::to_string(elevationNumber) +
         "), " + (gaps > 1 ? "in " + std::to_string(gaps) + " gaps, the first " : "") + place;
}

} // namespace nexrad

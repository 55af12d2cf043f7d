// SPDX-License-Identifier: BSD-3-Clause
#include "nexrad/Level2/SweepWatch.h"

#include <cmath>
#include <cstdio>

namespace nexrad
{

namespace
{

constexpr std::uint8_t endOfCut = 2;
constexpr std::uint8_t endOfVolume = 4;

bool StartsCut(std::uint8_t radialStatus)
{
  return radialStatus == 0 || radialStatus == 3 || radialStatus == 5;
}

} // namespace

double SweepWatch::TurnTo(float azimuth) const
{
  // The remainder lies within -180 and 180 degrees: the antenna goes the short way between rays.
  return rays == 0 ? 0.0
                   : turned + std::remainder(static_cast<double>(azimuth) - lastAzimuth, 360.0);
}

void SweepWatch::Add(const DecodedRay& decoded, std::uint64_t offset)
{
  const Ray& ray = decoded.ray;
  const unsigned number = decoded.azimuthNumber;
  if (rays == 0 && number > 1 && !StartsCut(ray.radialStatus))
  {
    this->Count(number - 1, ray.azimuth, ray.azimuth, offset);
  }
  else if (rays > 0 && number > lastNumber + 1)
  {
    this->Count(number - lastNumber - 1, lastAzimuth, ray.azimuth, offset);
  }
  turned = this->TurnTo(ray.azimuth);
  lastAzimuth = ray.azimuth;
  lastNumber = number;
  lastStatus = ray.radialStatus;
  lastOffset = offset;
  ++rays;
}

void SweepWatch::Count(std::size_t lost, float from, float to, std::uint64_t offset)
{
  if (gaps == 0)
  {
    gapFrom = from;
    gapTo = to;
    missingOffset = offset;
  }
  missing += lost;
  ++gaps;
}

bool SweepWatch::IsCutOff() const
{
  constexpr double almostFull = 358.0; // a full turn less one ray at each end
  return rays > 0 && lastStatus != endOfCut && lastStatus != endOfVolume &&
         std::abs(turned) < almostFull;
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

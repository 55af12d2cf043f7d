// SPDX-License-Identifier: BSD-3-Clause
#include "nexrad/Level2/Messages/DecodedRay.h"

#include "nexrad/Compression/DecodingBudget.h"

#include <algorithm>
#include <cmath>

namespace nexrad
{

namespace
{

constexpr std::uint8_t lastRadialStatus = 5;
constexpr std::uint8_t lastElevationNumber = 32; // ICD 2620002, tables III and XVII-A

bool IsWithin(float angle, float lowest, float highest)
{
  return std::isfinite(angle) && angle >= lowest && angle <= highest;
}

} // namespace

void CheckRay(const Ray& ray)
{
  if (!IsWithin(ray.azimuth, 0.0F, 360.0F))
  {
    throw MessageError("a ray whose azimuth is not within 0 to 360 degrees");
  }
  if (!IsWithin(ray.elevation, -10.0F, 90.0F))
  {
    throw MessageError("a ray whose elevation is not within -10 to 90 degrees");
  }
  if (ray.elevationNumber < 1 || ray.elevationNumber > lastElevationNumber)
  {
    throw MessageError("a ray whose elevation number is not within 1 to 32");
  }
  if (ray.radialStatus > lastRadialStatus)
  {
    throw MessageError("a ray whose radial status is not within 0 to 5");
  }
}

Time CheckedTime(std::uint32_t day, std::uint32_t milliseconds)
{
  constexpr std::uint32_t lastDay = 40'000;                // in the year 2079
  constexpr std::uint32_t longestDay = 86'400'000 + 1'000; // with a leap second
  if (day < 1 || day > lastDay || milliseconds >= longestDay)
  {
    throw MessageError("a ray whose date or time of day cannot be");
  }
  return FromLevel2Date(day, milliseconds);
}

std::size_t RayCosts::Of(const DecodedRay& decoded, std::size_t newBytes)
{
  std::size_t words = 0;
  for (const MomentRow& row : decoded.ray.moments)
  {
    words += row.gates * std::size_t(row.wordBits) / 8;
  }
  return (words > newBytes ? words - newBytes : 0) +
         DecodingBudget::JudgedGateCost * std::max(decoded.ray.Row(MomentName::REF).gates,
                                            decoded.ray.Row(MomentName::VEL).gates) +
         (this->MayBeginSweep(decoded.ray) ? DecodingBudget::SweepCost : 0) +
         DecodingBudget::DamageCost * decoded.problems.size();
}

bool RayCosts::MayBeginSweep(const Ray& ray)
{
  constexpr double longestTurn = 360.0; // less than that of a sweep
  turned += std::abs(std::remainder(static_cast<double>(ray.azimuth) - azimuth, 360.0));
  azimuth = static_cast<double>(ray.azimuth);
  const bool begins = ray.elevationNumber != elevationNumber ||
                      ray.radialStatus == RadialStatus::StartOfCut ||
                      ray.radialStatus == RadialStatus::StartOfVolume ||
                      ray.radialStatus == RadialStatus::StartOfLastCut || turned > longestTurn;
  elevationNumber = ray.elevationNumber;
  turned = begins ? 0.0 : turned;
  return begins;
}

} // namespace nexrad

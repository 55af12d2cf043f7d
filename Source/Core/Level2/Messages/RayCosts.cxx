// SPDX-License-Identifier: BSD-3-Clause
#include "nexrad/Level2/Messages/RayCosts.h"

#include "nexrad/Compression/DecodingBudget.h"

#include <algorithm>
#include <cmath>

namespace nexrad
{

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

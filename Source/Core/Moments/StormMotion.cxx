// SPDX-License-Identifier: BSD-3-Clause
#include "nexrad/Moments/StormMotion.h"

#include "nexrad/Velocity/VelocityAzimuthDisplay.h"

namespace nexrad
{

std::optional<Wind> EstimateStormMotion(const VelocityVolume& volume)
{
  constexpr int steps = 60;
  const double beside = 0.5 * ProfileOptions().layerDepth;
  const WindProfile near = FitWindProfile(volume);
  ProfileOptions farther;
  farther.farthest = FarthestSteeringWind;
  const WindProfile far = FitWindProfile(volume, farther);
  Wind sum;
  int known = 0;
  for (int step = 0; step < steps; ++step)
  {
    const double height = (step + 0.5) * SteeringDepth / steps;
    std::optional<Wind> wind = near.At(height, beside);
    wind = wind ? wind : far.At(height, beside);
    if (wind)
    {
      sum.east += wind->east;
      sum.north += wind->north;
      ++known;
    }
  }
  if (3 * known < steps)
  {
    return std::nullopt;
  }
  return Wind{sum.east / known, sum.north / known};
}

} // namespace nexrad

// SPDX-License-Identifier: BSD-3-Clause
#include "nexrad/Moments/MomentMaker.h"

#include "Scans/SimulatedVelocities.h"
#include "Tolerance.h"
#include "nexrad/Simulation/StormWind.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace nexrad
{

namespace
{

// The SYNTHETIC day's mean wind is known at each height; that of the storms adds to it.
double ErrorAt(const char* site)
{
  const testing::SimulatedVelocities simulated = testing::SimulateVelocities(site, 21);
  const auto motion = EstimateStormMotion(simulated.truth);
  if (!motion)
  {
    return std::numeric_limits<double>::infinity();
  }
  const double antenna = simulated.volume.site.position->altitude;
  Wind mean;
  for (int step = 0; step < 60; ++step)
  {
    const WindVector wind = MeanWind(antenna + 100.0 * step + 50.0);
    mean.east += wind.east / 60.0;
    mean.north += wind.north / 60.0;
  }
  return std::hypot(motion->east - mean.east, motion->north - mean.north);
}

} // namespace

TEST(StormMotion, IsTheMeanWindOfTheLowestSixKilometres)
{
  EXPECT_AT_MOST(ErrorAt("KLSX"), 0.13, "storm motion off the mean wind, m/s");
}

// Within 60 km of KEAX nothing tells the wind above 2 km, whose mean would be 10 m/s off.
TEST(StormMotion, TakesTheWindAloftFromFartherAway)
{
  EXPECT_AT_MOST(
    ErrorAt("KEAX"), 1.1, "storm motion off the mean wind, with the wind aloft from afar, m/s");
}

// The lowest tilt is 1.5 km high at 100 km.
TEST(StormMotion, IsUnknownWhereTheProfileEndsLow)
{
  testing::SimulatedVelocities simulated = testing::SimulateVelocities("KLSX", 21);
  simulated.truth.sweeps.resize(1);
  VelocitySweep& sweep = simulated.truth.sweeps.front();
  for (std::size_t index = 0; index < sweep.values.size(); ++index)
  {
    if (sweep.RangeOf(index % sweep.gates) > 100'000.0)
    {
      sweep.values[index] = std::numeric_limits<float>::quiet_NaN();
      sweep.states[index] = GateState::NotSampled;
    }
  }
  EXPECT_FALSE(EstimateStormMotion(simulated.truth));
}

TEST(StormMotion, IsUnknownWithoutVelocities)
{
  EXPECT_FALSE(EstimateStormMotion({}));
}

} // namespace nexrad

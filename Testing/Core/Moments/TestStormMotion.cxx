// SPDX-License-Identifier: BSD-3-Clause
#include "nexrad/Moments/StormMotion.h"

#include "Scans/SimulatedVelocities.h"
#include "Tolerance.h"
#include "nexrad/Simulation/Wind/MeanWind.h"

#include <gtest/gtest.h>

#include <cmath>

using namespace nexrad;

// The SYNTHETIC day's mean wind is known at each height; that of the storms adds to it.
TEST(StormMotion, IsTheMeanWindOfTheLowestSixKilometres)
{
  const testing::SimulatedVelocities volume = testing::SimulateVelocities("KEAX", 21);
  const std::optional<Wind> motion = EstimateStormMotion(volume.truth);
  ASSERT_TRUE(motion);
  const double antenna = volume.truth.site.position->altitude;
  Wind mean;
  for (int step = 0; step < 60; ++step)
  {
    const WindVector wind = MeanWind(antenna + 100.0 * step + 50.0);
    mean.east += wind.east / 60.0;
    mean.north += wind.north / 60.0;
  }
  EXPECT_AT_MOST(std::hypot(motion->east - mean.east, motion->north - mean.north), 3.0,
    "storm motion off the mean wind, m/s");
}

TEST(StormMotion, IsUnknownWithoutVelocities)
{
  EXPECT_FALSE(EstimateStormMotion({}));
}

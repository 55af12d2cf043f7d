// SPDX-License-Identifier: BSD-3-Clause
// Wind profiles: between their levels, and found in folded velocities of a SYNTHETIC wind
// (Formulas V3).
#include "Tolerance.h"
#include "VelocityScan.h"
#include "nexrad/Velocity/FoldedWind.h"

#include <gtest/gtest.h>

#include <cmath>

using namespace nexrad;
using namespace nexrad::testing;

namespace
{

Wind TurningWind(const PlaceOverRadar& place)
{
  return WindFrom(150.0 + place.height / 100.0, 15.0 + place.height / 250.0);
}

// The largest distance of a profile's levels from the truth, m/s.
double WorstLevel(const VelocityVolume& volume, std::size_t& levels)
{
  std::vector<SweepRing> rings;
  for (const VelocitySweep& sweep : volume.sweeps)
  {
    rings.push_back(MakeSweepRing(sweep));
  }
  std::vector<const SweepRing*> pointers;
  for (const SweepRing& ring : rings)
  {
    pointers.push_back(&ring);
  }
  const WindProfile profile = FindFoldedWind(pointers);
  double worst = 0.0;
  for (const ProfileLevel& level : profile.levels)
  {
    const Wind truth = TurningWind({0.0, 0.0, level.height});
    worst =
      std::max(worst, std::hypot(level.wind.east - truth.east, level.wind.north - truth.north));
  }
  levels = profile.levels.size();
  return worst;
}

} // namespace

TEST(Wind, HasASpeedAndADirectionThatItComesFrom)
{
  const Wind west = WindFrom(270.0, 10.0);
  EXPECT_NEAR(west.east, 10.0, 1e-9);
  EXPECT_NEAR(west.north, 0.0, 1e-9);
  EXPECT_NEAR(WindFrom(200.0, 25.0).Direction(), 200.0, 1e-9);
  EXPECT_NEAR(WindFrom(200.0, 25.0).Speed(), 25.0, 1e-9);
}

TEST(WindProfile, InterpolatesBetweenItsLevels)
{
  WindProfile profile;
  EXPECT_FALSE(profile.At(1000.0));
  profile.levels = {{1000.0, {10.0, 0.0}}, {2000.0, {20.0, 4.0}}, {6000.0, {30.0, 0.0}}};
  ASSERT_TRUE(profile.At(1500.0));
  EXPECT_EQ(profile.At(1500.0)->east, 15.0);
  EXPECT_EQ(profile.At(1500.0)->north, 2.0);
  EXPECT_EQ(profile.At(500.0)->east, 10.0);
  EXPECT_EQ(profile.At(2800.0)->east, 20.0);
  EXPECT_FALSE(profile.At(4000.0)); // the levels about it are too far apart
  EXPECT_FALSE(profile.At(7500.0));
  EXPECT_EQ(profile.At(7500.0, 2000.0)->east, 30.0);
  EXPECT_EQ(profile.DistanceTo(4500.0), 1500.0);
}

TEST(FoldedWind, IsFoundBeforeAnyFoldIs)
{
  VelocityScan scan;
  scan.wind = TurningWind;
  for (const float nyquist : {12.0F, 25.0F})
  {
    SCOPED_TRACE(nyquist);
    std::size_t levels = 0;
    EXPECT_AT_MOST(
      WorstLevel(FoldedAt(ScanVelocities(scan), nyquist), levels), 1.0, "wind of a layer off, m/s");
    EXPECT_EQ(levels, 40u);
  }
}

// Echo on one side of the radar only.
TEST(FoldedWind, IsFoundInAThirdOfTheDirections)
{
  VelocityScan scan;
  scan.wind = TurningWind;
  scan.echo = [](const PlaceOverRadar& place) { return place.north > 0.6 * std::abs(place.east); };
  std::size_t levels = 0;
  EXPECT_AT_MOST(
    WorstLevel(FoldedAt(ScanVelocities(scan), 12.0F), levels), 1.0, "wind of a layer off, m/s");
  EXPECT_EQ(levels, 40u);
}

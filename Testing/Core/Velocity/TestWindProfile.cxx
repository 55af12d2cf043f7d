// SPDX-License-Identifier: BSD-3-Clause
// Wind profiles: between their levels, and found in folded velocities of a SYNTHETIC wind
// (Formulas V3).
#include "Tolerance.h"
#include "VelocityScan.h"
#include "nexrad/Model/SiteTable.h"
#include "nexrad/Simulation/RadarSimulator.h"
#include "nexrad/Simulation/StormWind.h"
#include "nexrad/Velocity/Dealiasing.h"
#include "nexrad/Velocity/FoldedWind.h"
#include "nexrad/Velocity/WindProfile.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>

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

namespace
{

// The largest distance of a fitted profile's levels from a wind, m/s.
double WorstFit(const WindProfile& profile, const std::function<Wind(double)>& truth)
{
  double worst = 0.0;
  for (const ProfileLevel& level : profile.levels)
  {
    const Wind wind = truth(level.height);
    worst = std::max(worst, std::hypot(level.wind.east - wind.east, level.wind.north - wind.north));
  }
  return worst;
}

} // namespace

TEST(VelocityAzimuthDisplay, GivesAUniformWind)
{
  VelocityScan scan;
  scan.wind = [](const PlaceOverRadar&) { return WindFrom(230.0, 35.0); };
  VelocityVolume volume = FoldedAt(ScanVelocities(scan), 12.0F);
  Dealias(volume);
  const WindProfile profile = FitWindProfile(volume);
  EXPECT_AT_LEAST(profile.levels.size(), 60u, "levels of 300 m");
  EXPECT_AT_MOST(WorstFit(profile, [](double) { return WindFrom(230.0, 35.0); }), 0.2,
    "wind of a level off, m/s");
  for (const ProfileLevel& level : profile.levels)
  {
    EXPECT_WITHIN(level.rms, 1.0, 0.2, "RMS less the noise, m/s");
  }
}

TEST(VelocityAzimuthDisplay, GivesAShearedWind)
{
  VelocityScan scan;
  scan.wind = TurningWind;
  VelocityVolume volume = FoldedAt(ScanVelocities(scan), 25.0F);
  Dealias(volume);
  const auto truth = [](double height) { return TurningWind({0.0, 0.0, height}); };
  EXPECT_AT_MOST(WorstFit(FitWindProfile(volume), truth), 0.4, "wind of a level off, m/s");
}

// One direction determines no wind, and half of a circle of gates that differ determines none
// either.
TEST(VelocityAzimuthDisplay, LeavesOutWhatIsNoWind)
{
  VelocityScan scan;
  scan.wind = TurningWind;
  scan.echo = [](const PlaceOverRadar& place) { return place.north > 2.0 * std::abs(place.east); };
  EXPECT_TRUE(FitWindProfile(ScanVelocities(scan)).levels.empty());
  scan.echo = nullptr;
  scan.noise = 8.0;
  EXPECT_TRUE(FitWindProfile(ScanVelocities(scan)).levels.empty());
}

// The mean wind of the SYNTHETIC storm day, through its storms.
TEST(VelocityAzimuthDisplay, GivesTheSimulatedProfile)
{
  const Site site = {"KLSX", FindSite("KLSX")->position};
  VelocityVolume volume = MakeVelocityVolume(MakePolarVolume(
    ScanVolume(StormField(), site, 11, *ParseIso8601("2006-03-12T18:30Z")), MomentName::VEL));
  Dealias(volume);
  const WindProfile profile = FitWindProfile(volume);
  EXPECT_AT_LEAST(profile.levels.size(), 30u, "levels of 300 m");
  const double altitude = site.position->altitude;
  EXPECT_AT_MOST(WorstFit(profile,
                   [altitude](double height)
                   {
                     const WindVector wind = MeanWind(height + altitude);
                     return Wind{wind.east, wind.north};
                   }),
    0.7, "wind of a level off, m/s");
}

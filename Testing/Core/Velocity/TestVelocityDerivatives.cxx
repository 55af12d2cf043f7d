// SPDX-License-Identifier: BSD-3-Clause
// Formulas P5, V5 and V6 on SYNTHETIC fields whose derivatives are known.
#include "TestData.h"
#include "Tolerance.h"
#include "VelocityScan.h"
#include "nexrad/Level2/Level2File.h"
#include "nexrad/Moments/PhaseSlopes.h"
#include "nexrad/System/Error.h"
#include "nexrad/Velocity/Dealiasing.h"
#include "nexrad/Velocity/VelocityDerivatives.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <random>

using namespace nexrad;
using namespace nexrad::testing;

namespace
{

constexpr double rotation = 0.01; // per second
constexpr double coreNorth = 40'000.0;
constexpr double coreRadius = 5'000.0;

VelocityScan Scan(const std::function<Wind(const PlaceOverRadar&)>& wind)
{
  VelocityScan scan;
  scan.elevations = {0.5};
  scan.rays = 720;
  scan.gates = 240;
  scan.noise = 0.0;
  scan.wind = wind;
  return scan;
}

bool IsInCore(const VelocitySweep& sweep, std::size_t ray, std::size_t gate, double radius)
{
  const double azimuth = static_cast<double>(sweep.rays[ray].azimuth) * 3.14159265 / 180.0;
  const double range = sweep.RangeOf(gate);
  return std::hypot(range * std::sin(azimuth), range * std::cos(azimuth) - coreNorth) < radius;
}

// The largest error of a field, in parts of the truth, inside the core and away from its edge. The
// truth is that at the core's middle times `atRange` of the range.
double LargestError(const VelocitySweep& sweep, const std::vector<float>& field,
  const std::function<double(double)>& atRange)
{
  double largest = 0.0;
  for (std::size_t ray = 0; ray < sweep.rays.size(); ++ray)
  {
    for (std::size_t gate = 0; gate < sweep.gates; ++gate)
    {
      if (IsInCore(sweep, ray, gate, coreRadius - 1'500.0))
      {
        const double truth = rotation * atRange(sweep.RangeOf(gate));
        const auto value = static_cast<double>(field[sweep.Index(ray, gate)]);
        largest = std::isnan(value) ? 1.0 : std::max(largest, std::abs(value / truth - 1.0));
      }
    }
  }
  return largest;
}

} // namespace

// The radial velocity of a solid body is the same at all ranges of an azimuth, so the shear of the
// arc falls with the range.
TEST(AzimuthalShear, OfASolidBodyIsItsRotation)
{
  const VelocityVolume volume = ScanVelocities(Scan(
    [](const PlaceOverRadar& place)
    {
      const double north = place.north - coreNorth;
      const double distance = std::hypot(place.east, north);
      const double speed =
        rotation * std::min(1.0, coreRadius * coreRadius / (distance * distance));
      return Wind{-speed * north, speed * place.east};
    }));
  const VelocitySweep& sweep = volume.sweeps[0];
  const auto atRange = [](double range) { return coreNorth / range; };
  EXPECT_AT_MOST(LargestError(sweep, AzimuthalShear(sweep), atRange), 0.007,
    "shear of a solid body off, parts of it");
}

TEST(RadialDivergence, OfAUniformDivergenceIsItsRate)
{
  const VelocityVolume volume = ScanVelocities(Scan(
    [](const PlaceOverRadar& place) {
      return Wind{rotation * place.east, rotation * (place.north - coreNorth)};
    }));
  const VelocitySweep& sweep = volume.sweeps[0];
  const auto atRange = [](double) { return 1.0; };
  EXPECT_AT_MOST(
    LargestError(sweep, RadialDivergence(sweep), atRange), 0.00038, "divergence off, parts of it");
}

TEST(AzimuthalShear, IsVoidWhereAThirdOfTheWindowIs)
{
  VelocityScan scan = Scan([](const PlaceOverRadar&) { return Wind{0.0, 10.0}; });
  scan.echo = [](const PlaceOverRadar& place)
  { return place.east > 0.0 && std::abs(place.north) < 30'000.0; };
  const VelocityVolume volume = ScanVelocities(scan);
  const VelocitySweep& sweep = volume.sweeps[0];
  const std::vector<float> shear = AzimuthalShear(sweep);
  EXPECT_TRUE(std::isnan(shear[sweep.Index(0, 100)]));    // at the edge of the echo
  EXPECT_FALSE(std::isnan(shear[sweep.Index(180, 100)])); // in the middle of it
  EXPECT_TRUE(std::isnan(shear[sweep.Index(500, 100)]));  // outside
}

// The tornado of 1999-05-03 at 23:56 UTC, 257° and 38 km from KTLX, turns anticlockwise.
TEST(AzimuthalShear, IsLargestInATornado)
{
  NEXRAD_REQUIRE_TEST_DATA(folder);
  VelocityVolume volume = MakeVelocityVolume(
    MakePolarVolume(ReadLevel2(folder / "level2/legacy/KTLX19990503_235621.gz"), MomentName::VEL));
  Dealias(volume);
  const VelocitySweep& sweep = volume.sweeps.front();
  const std::vector<float> shear = AzimuthalShear(sweep);
  float largest = 0.0F;
  std::size_t place = 0;
  for (std::size_t index = 0; index < shear.size(); ++index)
  {
    const double range = sweep.RangeOf(index % sweep.gates);
    if (range > 20'000.0 && range < 60'000.0 && shear[index] > largest)
    {
      largest = shear[index];
      place = index;
    }
  }
  EXPECT_AT_LEAST(largest, 0.04, "shear of the tornado, per second");
  EXPECT_NEAR(sweep.rays[place / sweep.gates].azimuth, 257.0F, 2.0F);
  EXPECT_NEAR(sweep.RangeOf(place % sweep.gates), 38'500.0, 1'500.0);
}

TEST(StormRelativeVelocity, LeavesOutTheMotion)
{
  const Wind motion = WindFrom(230.0, 20.0);
  VelocityVolume volume = ScanVelocities(Scan(
    [motion](const PlaceOverRadar&) {
      return Wind{motion.east + 3.0, motion.north};
    }));
  VelocitySweep& sweep = volume.sweeps[0];
  SubtractMotion(sweep, motion);
  EXPECT_NEAR(sweep.values[sweep.Index(180, 50)], 3.0F, 0.01F); // towards the east
  EXPECT_NEAR(sweep.values[sweep.Index(0, 50)], 0.0F, 0.02F);   // towards the north
}

TEST(SpecificDifferentialPhase, IsHalfTheSlopeOfThePhase)
{
  constexpr float none = std::numeric_limits<float>::quiet_NaN();
  for (const float reflectivity : {20.0F, 50.0F})
  {
    std::vector<float> phase;
    for (int gate = 0; gate < 400; ++gate)
    {
      // The phase rises by 2 degrees a km, which is a K_DP of 1 degree a km.
      phase.push_back(
        std::fmod(300.0F + 0.5F * float(gate) + (gate % 2 == 0 ? 1.0F : -1.0F), 360.0F));
    }
    phase[100] = 77.0F; // one gate of noise
    phase[200] = none;
    const std::vector<float> result =
      SpecificDifferentialPhase(phase, std::vector<float>(400, reflectivity), 250.0);
    for (std::size_t gate = 30; gate < 370; ++gate)
    {
      if (gate != 200)
      {
        EXPECT_WITHIN(result[gate], 1.0, 0.089, "K_DP of a steady slope, degrees a km");
      }
    }
    EXPECT_TRUE(std::isnan(result[200]));
  }
  EXPECT_THROW(SpecificDifferentialPhase({1.0F}, {}, 250.0), Error);
}

// The noise of the phase is 3 degrees. A window that becomes shorter towards the ends would give
// errors of several degrees/km there.
TEST(SpecificDifferentialPhase, HasNoSpikesAtTheEndsOfEcho)
{
  constexpr float none = std::numeric_limits<float>::quiet_NaN();
  std::mt19937 generator(3);
  double atEnds = 0.0;
  double within = 0.0;
  for (int ray = 0; ray < 200; ++ray)
  {
    std::vector<float> phase(400, none);
    for (std::size_t gate = 0; gate < phase.size(); ++gate)
    {
      const double noise = 12.0 * (static_cast<double>(generator()) / 4294967296.0 - 0.5);
      if ((gate >= 100 && gate < 180) || gate >= 300) // two stretches, one to the end of the ray
      {
        phase[gate] = static_cast<float>(60.0 + 0.5 * static_cast<double>(gate) + noise);
      }
    }
    const std::vector<float> result =
      SpecificDifferentialPhase(phase, std::vector<float>(400, 30.0F), 250.0);
    for (const std::size_t gate : {100, 101, 178, 179, 300, 301, 398, 399})
    {
      ASSERT_FALSE(std::isnan(result[gate])) << gate;
      atEnds = std::max(atEnds, std::abs(static_cast<double>(result[gate]) - 1.0));
    }
    for (const std::size_t gate : {130, 140, 150, 340, 350, 360})
    {
      within = std::max(within, std::abs(static_cast<double>(result[gate]) - 1.0));
    }
    EXPECT_TRUE(std::isnan(result[99]));
    EXPECT_TRUE(std::isnan(result[180]));
  }
  EXPECT_AT_MOST(atEnds, 1.0, "largest error of K_DP at ends of echo, degrees/km");
  EXPECT_AT_MOST(within, 0.7, "largest error of K_DP within echo, degrees/km");
}

// A phase that is noise has no slope, also in echo whose correlation happens to be high.
TEST(SpecificDifferentialPhase, IsVoidInNoise)
{
  std::mt19937 generator(4);
  std::vector<float> phase;
  for (int gate = 0; gate < 2000; ++gate)
  {
    phase.push_back(static_cast<float>(360.0 * static_cast<double>(generator()) / 4294967296.0));
  }
  const std::vector<float> result =
    SpecificDifferentialPhase(phase, std::vector<float>(2000, 10.0F), 250.0);
  const auto known =
    std::count_if(result.begin(), result.end(), [](float value) { return !std::isnan(value); });
  EXPECT_AT_MOST(known, 0, "gates of noise with a K_DP");
}

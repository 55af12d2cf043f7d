// SPDX-License-Identifier: BSD-3-Clause
// Formulas V4: folds for which nothing vouches, of SYNTHETIC interference in synthetic and real
// velocities, and of a real spike.
#include "FoldScore.h"
#include "TestData.h"
#include "Tolerance.h"
#include "VelocityScan.h"
#include "nexrad/Geometry/Angles.h"
#include "nexrad/Level2/Level2File.h"
#include "nexrad/Velocity/Dealiasing.h"
#include "nexrad/Velocity/FoldSupport.h"
#include "nexrad/Velocity/FoldedWind.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <random>
#include <string>
#include <vector>

using namespace nexrad;
using namespace nexrad::testing;

namespace
{

// A part of a sweep with velocities that are not of the wind.
struct Spike
{
  double azimuth = 30.5;    // degrees, its middle
  double width = 2.0;       // degrees
  double from = 70'000.0;   // m
  double to = 120'000.0;    // m
  double velocity = -12.0;  // m/s, mean
  double noise = 3.0;       // m/s, the most, evenly
  bool inAllSweeps = false; // or in the first alone
};

bool IsIn(const Spike& spike, const VelocitySweep& sweep, std::size_t ray, std::size_t gate)
{
  const double away = AngleDifference(spike.azimuth, static_cast<double>(sweep.rays[ray].azimuth));
  const double range = sweep.RangeOf(gate);
  return std::abs(away) < 0.5 * spike.width && range > spike.from && range < spike.to;
}

// Puts the spike into gates without a velocity.
void Add(const Spike& spike, VelocityVolume& volume)
{
  std::mt19937 generator(14);
  for (VelocitySweep& sweep : volume.sweeps)
  {
    for (std::size_t ray = 0; ray < sweep.rays.size(); ++ray)
    {
      for (std::size_t gate = 0; gate < sweep.gates; ++gate)
      {
        float& value = sweep.values[sweep.Index(ray, gate)];
        if (IsIn(spike, sweep, ray, gate) && std::isnan(value))
        {
          const double even = static_cast<double>(generator()) / 2147483648.0 - 1.0;
          value = std::remainder(static_cast<float>(spike.velocity + spike.noise * even),
            2.0F * sweep.rays[ray].nyquist);
          sweep.states[sweep.Index(ray, gate)] = GateState::Valid;
        }
      }
    }
    if (!spike.inAllSweeps)
    {
      return;
    }
  }
}

// Percent of the gates of a spike that have another velocity than before dealiasing, and a faster
// one than `speed`, m/s.
double PercentMoved(
  const Spike& spike, const VelocityVolume& before, const VelocityVolume& after, double speed = 0.0)
{
  std::size_t all = 0;
  std::size_t moved = 0;
  for (std::size_t each = 0; each < (spike.inAllSweeps ? before.sweeps.size() : 1); ++each)
  {
    const VelocitySweep& sweep = before.sweeps[each];
    for (std::size_t ray = 0; ray < sweep.rays.size(); ++ray)
    {
      for (std::size_t gate = 0; gate < sweep.gates; ++gate)
      {
        const std::size_t index = sweep.Index(ray, gate);
        if (IsIn(spike, sweep, ray, gate) && sweep.states[index] == GateState::Valid)
        {
          ++all;
          moved += after.sweeps[each].states[index] == GateState::Valid &&
                       after.sweeps[each].values[index] != sweep.values[index] &&
                       std::abs(static_cast<double>(after.sweeps[each].values[index])) > speed
                     ? 1
                     : 0;
        }
      }
    }
  }
  EXPECT_GT(all, 20U);
  return 100.0 * static_cast<double>(moved) / static_cast<double>(all);
}

double PercentMoved(const Spike& spike, VelocityVolume volume, double speed = 0.0)
{
  Add(spike, volume);
  VelocityVolume result = volume;
  Dealias(result);
  return PercentMoved(spike, volume, result, speed);
}

// Clear air within 40 km of the radar in a wind of 22 m/s from the south-south-west.
VelocityVolume ClearAir(std::vector<double> elevations = {0.5, 1.5, 2.4})
{
  VelocityScan scan;
  scan.elevations = std::move(elevations);
  scan.gates = 500;
  scan.wind = [](const PlaceOverRadar&) { return WindFrom(205.0, 22.0); };
  scan.echo = [](const PlaceOverRadar& place)
  { return std::hypot(place.east, place.north) < 40'000.0; };
  return FoldedAt(ScanVelocities(scan), 28.0F);
}

} // namespace

TEST(FoldSupport, LeavesSpikesAsTheyAreOrUnknown)
{
  for (const double width : {0.5, 2.5, 4.5})
  {
    for (const bool inAllSweeps : {false, true})
    {
      SCOPED_TRACE(std::to_string(width) + (inAllSweeps ? "°, all sweeps" : "°, one sweep"));
      Spike spike;
      spike.width = width;
      spike.inAllSweeps = inAllSweeps;
      EXPECT_EQ(PercentMoved(spike, ClearAir()), 0.0);
      spike.from = 45'000.0;
      spike.to = 52'000.0; // short, and near
      EXPECT_EQ(PercentMoved(spike, ClearAir()), 0.0);
    }
  }
}

// Echo of an earlier pulse: broad, and far from all other echo.
TEST(FoldSupport, LeavesABroadPatchFarFromTheWindAsItIsOrUnknown)
{
  Spike patch;
  patch.width = 15.0;
  patch.noise = 1.0;
  EXPECT_EQ(PercentMoved(patch, ClearAir()), 0.0);
}

// Single gates of noise may come near to the wind of 22 m/s.
TEST(FoldSupport, MakesNoNoiseFast)
{
  Spike patch;
  patch.width = 3.0;
  patch.noise = 28.0;
  patch.inAllSweeps = true;
  EXPECT_EQ(PercentMoved(patch, ClearAir(), 40.0), 0.0);
}

// A wind profile is not made of interference in all directions.
TEST(FoldSupport, InterferenceMakesNoWindProfile)
{
  VelocityScan scan;
  scan.elevations = {0.5, 1.5, 2.4};
  scan.wind = [](const PlaceOverRadar&) { return Wind{}; };
  scan.echo = [](const PlaceOverRadar&) { return false; };
  VelocityVolume volume = FoldedAt(ScanVelocities(scan), 28.0F);
  for (int each = 0; each < 12; ++each)
  {
    Spike spike;
    spike.azimuth = 30.0 * each + 5.0;
    spike.width = 4.0;
    spike.from = 10'000.0;
    spike.velocity = std::remainder(17.0 * each * each, 56.0);
    spike.inAllSweeps = true;
    Add(spike, volume);
  }
  std::vector<SweepRing> rings;
  for (const VelocitySweep& sweep : volume.sweeps)
  {
    rings.push_back(MakeSweepRing(sweep));
  }
  EXPECT_TRUE(FindFoldedWind({&rings[0], &rings[1], &rings[2]}).levels.empty());
}

// Storms of a few rays in a wind of 34 m/s: the wind profile and the other sweeps vouch for them.
TEST(FoldSupport, KeepsNarrowStorms)
{
  VelocityScan scan;
  scan.elevations = {0.5, 1.5, 2.4};
  scan.wind = [](const PlaceOverRadar&) { return WindFrom(205.0, 34.0); };
  scan.echo = [](const PlaceOverRadar& place)
  {
    const double east = std::remainder(place.east, 20'000.0);
    const double north = std::remainder(place.north, 20'000.0);
    return std::hypot(place.east, place.north) < 30'000.0 || std::hypot(east, north) < 2'500.0;
  };
  const VelocityVolume truth = ScanVelocities(scan);
  VelocityVolume volume = FoldedAt(truth, 28.0F);
  EXPECT_GT(Dealias(volume).unfolded, 10'000U);
  const FoldScore score = CompareFolds(truth, volume);
  EXPECT_EQ(score.wrong, 0U);
  EXPECT_AT_MOST(score.UnknownShare(), 0.05, "gates of narrow storms without a fold, %");
}

TEST(FoldSupport, TheFastestWindRisesWithTheHeight)
{
  EXPECT_DOUBLE_EQ(FastestWind(500.0), 60.0);
  EXPECT_DOUBLE_EQ(FastestWind(7'500.0), 80.0);
  EXPECT_DOUBLE_EQ(FastestWind(12'000.0), 100.0);
}

// Interference at 29° to 31°, 90 to 125 km, over clear air: −23 to −2 m/s in the file.
TEST(FoldSupport, LeavesARealSpikeAsItIsOrUnknown)
{
  NEXRAD_REQUIRE_TEST_DATA(folder);
  const VelocityVolume before = MakeVelocityVolume(MakePolarVolume(
    ReadLevel2(folder / "reports" / "radar" / "interference-unfolded" / "KLOT20210625_075154_V06"),
    MomentName::VEL));
  VelocityVolume after = before;
  Dealias(after);
  Spike spike;
  spike.width = 6.0;
  spike.from = 85'000.0;
  spike.to = 130'000.0;
  EXPECT_EQ(PercentMoved(spike, before, after), 0.0);
}

// The same kind of spike (SYNTHETIC) at other places of real volumes.
TEST(FoldSupport, LeavesSpikesInRealVolumesAsTheyAreOrUnknown)
{
  NEXRAD_REQUIRE_TEST_DATA(folder);
  for (const char* name : {"superres/KLSX20130206_175044_V06.gz",
         "superres/KTLX20190715_120037_V06", "legacy/KVWX_20050626_221551.gz"})
  {
    const VelocityVolume volume =
      MakeVelocityVolume(MakePolarVolume(ReadLevel2(folder / "level2" / name), MomentName::VEL));
    double most = 0.0;
    for (const double azimuth : {20.0, 110.0, 200.0, 290.0})
    {
      Spike spike;
      spike.azimuth = azimuth;
      spike.from = 100'000.0;
      spike.to = 160'000.0;
      spike.velocity = azimuth < 180.0 ? 16.0 : -16.0;
      most = std::max(most, PercentMoved(spike, volume));
    }
    EXPECT_AT_MOST(most, 2.0, std::string(name) + ": spike that is unfolded, % of its gates");
  }
}

// SPDX-License-Identifier: BSD-3-Clause
// One radar at several times, and several radars at one.
#include "BeamScene.h"
#include "Tolerance.h"

#include <gtest/gtest.h>

#include <limits>
#include <tuple>

using namespace nexrad;
using namespace nexrad::testing;

namespace
{

constexpr double minute = 60.0;

// The value of the voxel at a place, NaN where it holds no echo. The scene's columns are 5 km
// apart.
double ValueAt(const GriddedVolume& volume, int x, int y, int z)
{
  const std::size_t index = (static_cast<std::size_t>(z) * 61 + static_cast<std::size_t>(y)) * 61 +
                            static_cast<std::size_t>(x);
  return volume.states[index] == VoxelState::Echo ? static_cast<double>(volume.values[index])
                                                  : std::numeric_limits<double>::quiet_NaN();
}

// A volume of a single tilt, seen at 40 km to the east at level 4 (1.25 km).
double SeenEast(const std::vector<PolarVolume>& volumes, double seconds)
{
  return ValueAt(MergeAt(volumes, seconds), 38, 30, 4);
}

PolarVolume OneTilt(double seconds, float value)
{
  return VolumeOf({UniformSweep(1, 1.4, value, seconds)});
}

} // namespace

TEST(BeamTimes, LinearBetweenTheRaysBeforeAndAfter)
{
  const std::vector<PolarVolume> volumes = {OneTilt(0.0, 20.0F), OneTilt(300.0, 40.0F)};
  EXPECT_NEAR(SeenEast(volumes, 0.0), 20.0, 1e-3);
  EXPECT_NEAR(SeenEast(volumes, 75.0), 25.0, 1e-3);
  EXPECT_NEAR(SeenEast(volumes, 300.0), 40.0, 1e-3);
  EXPECT_NEAR(SeenEast(volumes, -100.0), 20.0, 1e-3); // one side alone, unchanged
  EXPECT_NEAR(SeenEast(volumes, 800.0), 40.0, 1e-3);
}

// The rays of a sweep are seconds apart: where it is in progress, what was scanned is before the
// time and what was not is after it.
TEST(BeamTimes, EachRayHasItsOwnTime)
{
  PolarVolume sweeping = OneTilt(0.0, 20.0F);
  for (std::size_t ray = 0; ray < 360; ++ray)
  {
    sweeping.sweeps[0].rays[ray].time = sceneTime + Duration(100 * ray);
  }
  const std::vector<PolarVolume> volumes = {OneTilt(-100.0, 0.0F), sweeping, OneTilt(136.0, 50.0F)};
  const GriddedVolume volume = MergeAt(volumes, 18.0);
  // East was scanned at 9 s, west at 27 s.
  EXPECT_NEAR(ValueAt(volume, 38, 30, 4), 20.0 + 30.0 * 9.0 / 127.0, 1e-3);
  EXPECT_NEAR(ValueAt(volume, 22, 30, 4), 20.0 * 118.0 / 127.0, 1e-3);
}

TEST(BeamTimes, NoEchoCountsAsZeroBetweenTimes)
{
  PolarVolume none = OneTilt(300.0, 0.0F);
  ChangeGates(none.sweeps[0], [](NumberSweep& sweep) { SetAll(sweep, GateState::BelowThreshold); });
  const std::vector<PolarVolume> volumes = {OneTilt(0.0, 40.0F), none};
  EXPECT_NEAR(SeenEast(volumes, 75.0), 30.0, 1e-3);
  EXPECT_TRUE(std::isnan(SeenEast(volumes, 300.0)));
}

TEST(BeamTimes, ARangeFoldedGateLeavesTheOtherSideAlone)
{
  PolarVolume folded = OneTilt(300.0, 0.0F);
  ChangeGates(folded.sweeps[0], [](NumberSweep& sweep) { SetAll(sweep, GateState::RangeFolded); });
  EXPECT_NEAR(SeenEast({OneTilt(0.0, 40.0F), folded}, 200.0), 40.0, 1e-3);
}

// Repeated cuts: the nearest on each side of the time.
TEST(BeamTimes, OfRepeatedCutsTheNearestCount)
{
  std::vector<NumberSweep> sweeps = {UniformSweep(1, 1.4, 10.0F, 0.0),
    UniformSweep(2, 2.5, 10.0F, 60.0), UniformSweep(3, 1.43, 30.0F, 120.0),
    UniformSweep(4, 4.0, 10.0F, 180.0), UniformSweep(5, 1.38, 50.0F, 240.0)};
  // The other tilts have 10 dBZ all the time: level 3 over 30 km stands at 1.43°, which is theirs
  // for 3 %.
  const auto seen = [&](double seconds)
  { return ValueAt(MergeAt({VolumeOf(sweeps)}, seconds), 36, 30, 3); };
  EXPECT_WITHIN(seen(60.0), 20.0, 1.6, "value of the nearest cut, dBZ");
  EXPECT_WITHIN(seen(180.0), 40.0, 1.6, "value of the nearest cut, dBZ");
  EXPECT_WITHIN(seen(500.0), 50.0, 1.6, "value of the nearest cut, dBZ");
}

TEST(BeamTimes, WhatIsFartherThanTheGapDoesNotCount)
{
  const std::vector<PolarVolume> one = {OneTilt(0.0, 20.0F)};
  EXPECT_NEAR(SeenEast(one, 14.9 * minute), 20.0, 1e-3);
  EXPECT_TRUE(std::isnan(SeenEast(one, 15.1 * minute)));
  EXPECT_TRUE(std::isnan(SeenEast(one, -15.1 * minute)));
}

// A radar that missed volumes: 25 minutes between two. The second fades in when it comes within the
// gap, the first fades out; no step is larger than the smallest times can explain.
TEST(BeamTimes, AMissedVolumeMakesNoJump)
{
  const std::vector<PolarVolume> volumes = {OneTilt(0.0, 20.0F), OneTilt(25.0 * minute, 50.0F)};
  double before = SeenEast(volumes, 0.0);
  for (double seconds = 20.0; seconds <= 25.0 * minute; seconds += 20.0)
  {
    const double now = SeenEast(volumes, seconds);
    ASSERT_FALSE(std::isnan(now)) << seconds;
    EXPECT_GE(now, before - 1e-3) << seconds;
    EXPECT_AT_MOST(now - before, 3.0, "change of the value in a step, dBZ")
      << seconds; // 0.4 if it were linear over the 25 minutes
    before = now;
  }
  EXPECT_NEAR(before, 50.0, 1e-3);
}

// A field that is linear in elevation and steady is the same at all times, although the pattern
// changes between the volumes.
TEST(BeamTimes, AChangeOfPatternMakesNoJump)
{
  const auto scan = [](const std::vector<double>& tilts, double seconds)
  {
    std::vector<NumberSweep> sweeps;
    for (std::size_t i = 0; i < tilts.size(); ++i)
    {
      sweeps.push_back(UniformSweep(static_cast<int>(i) + 1, tilts[i],
        static_cast<float>(20.0 + 5.0 * tilts[i]), seconds + 40.0 * static_cast<double>(i)));
    }
    return VolumeOf(sweeps);
  };
  const std::vector<double> first = {0.5, 1.5, 2.4, 3.4, 4.3, 6.0};
  const std::vector<double> second = {0.5, 0.9, 1.3, 1.8, 2.4, 3.1, 4.0, 5.1, 6.0};
  const std::vector<PolarVolume> volumes = {
    scan(first, -720.0), scan(first, -360.0), scan(second, 0.0), scan(second, 400.0)};
  for (const double seconds : {-200.0, -20.0, 0.0, 50.0, 130.0, 250.0, 330.0, 420.0})
  {
    const GriddedVolume volume = MergeAt(volumes, seconds, AsMeasured());
    const auto check = [&](const SeenVoxel& voxel)
    {
      if (voxel.groundDistance > 2'000.0 && voxel.elevation > 0.51 && voxel.elevation < 5.99)
      {
        ASSERT_EQ(volume.states[voxel.index], VoxelState::Echo);
        ASSERT_NEAR(volume.values[voxel.index], 20.0 + 5.0 * voxel.elevation, 1e-3) << seconds;
      }
    };
    ForEachVoxel(volume.grid, centralSite, check);
  }
}

namespace
{

const Position eastSite = {38.7, -91.0, 300.0};

// Two radars with one value each, 87 km apart.
std::vector<PolarVolume> TwoRadars(float west, float east)
{
  std::vector<PolarVolume> volumes;
  const std::vector<double> tilts = {0.5, 1.5, 2.5, 3.5, 4.5};
  for (const auto& [value, site, name] :
    {std::make_tuple(west, centralSite, "KWST"), std::make_tuple(east, eastSite, "KEST")})
  {
    std::vector<NumberSweep> sweeps;
    for (std::size_t i = 0; i < tilts.size(); ++i)
    {
      sweeps.push_back(UniformSweep(static_cast<int>(i) + 1, tilts[i], value));
      if (value == 0.0F)
      {
        SetAll(sweeps.back(), GateState::BelowThreshold);
      }
    }
    volumes.push_back(VolumeOf(sweeps, site));
    volumes.back().site.name = name;
  }
  return volumes;
}

// Distances to both radars of the voxels that both saw well inside their tilts.
void ForEachOverlap(
  const GridSpecification& grid, const std::function<void(std::size_t, double, double)>& visit)
{
  std::vector<double> west(grid.VoxelCount(), -1.0);
  const auto inside = [](const SeenVoxel& voxel)
  {
    return voxel.elevation > 0.1 && voxel.elevation < 4.9 && voxel.groundDistance > 3'000.0 &&
           voxel.groundDistance < 225'000.0;
  };
  ForEachVoxel(grid, centralSite,
    [&](const SeenVoxel& voxel) { west[voxel.index] = inside(voxel) ? voxel.slantRange : -1.0; });
  ForEachVoxel(grid, eastSite,
    [&](const SeenVoxel& voxel)
    {
      if (inside(voxel) && west[voxel.index] > 0.0)
      {
        visit(voxel.index, west[voxel.index], voxel.slantRange);
      }
    });
}

} // namespace

TEST(BeamOverlap, Strategies)
{
  const std::vector<PolarVolume> radars = TwoRadars(20.0F, 40.0F);
  const auto merge = [&](OverlapStrategy strategy)
  {
    BeamMergeOptions options;
    options.strategy = strategy;
    return MergeAt(radars, 0.0, options);
  };
  const GriddedVolume mean = merge(OverlapStrategy::Mean);
  const GriddedVolume nearest = merge(OverlapStrategy::Nearest);
  const GriddedVolume largest = merge(OverlapStrategy::Maximum);
  const GriddedVolume distance = merge(OverlapStrategy::Distance);
  std::size_t count = 0;
  const auto check = [&](std::size_t index, double west, double east)
  {
    ++count;
    ASSERT_NEAR(mean.values[index], 30.0, 1e-3);
    ASSERT_NEAR(largest.values[index], 40.0, 1e-3);
    if (std::abs(west - east) > 500.0)
    {
      ASSERT_NEAR(nearest.values[index], west < east ? 20.0 : 40.0, 1e-3);
    }
    const double a = std::exp(-west * west / 1e10);
    const double b = std::exp(-east * east / 1e10);
    ASSERT_WITHIN(distance.values[index], (20.0 * a + 40.0 * b) / (a + b), 0.016,
      "mean weighted by the distance, dBZ");
  };
  ForEachOverlap(mean.grid, check);
  EXPECT_AT_LEAST(count, 50'000u, "voxels of two radars");
}

TEST(BeamOverlap, EchoNeedsHalfOfTheWeight)
{
  const GriddedVolume volume = MergeAt(TwoRadars(30.0F, 0.0F), 0.0);
  BeamMergeOptions options;
  options.strategy = OverlapStrategy::Maximum;
  const GriddedVolume largest = MergeAt(TwoRadars(30.0F, 0.0F), 0.0, options);
  const auto check = [&](std::size_t index, double west, double east)
  {
    if (std::abs(west - east) > 2'000.0)
    {
      const VoxelState expected = west < east ? VoxelState::Echo : VoxelState::NoEcho;
      ASSERT_EQ(volume.states[index], expected);
    }
    ASSERT_EQ(largest.states[index], VoxelState::Echo);
  };
  ForEachOverlap(volume.grid, check);
}

TEST(BeamOverlap, VelocityComesFromTheNearestRadarWhateverTheStrategy)
{
  std::vector<PolarVolume> radars = TwoRadars(20.0F, 40.0F);
  for (PolarVolume& each : radars)
  {
    each.moment = MomentName::VEL;
  }
  const GriddedVolume volume = MergeAt(radars, 0.0);
  for (std::size_t i = 0; i < volume.values.size(); ++i)
  {
    ASSERT_TRUE(volume.states[i] != VoxelState::Echo || volume.values[i] == 20.0F ||
                volume.values[i] == 40.0F);
  }
}

TEST(BeamOverlap, AncillaryArraysSayWhoSawAVoxelAndWhen)
{
  std::vector<PolarVolume> radars = TwoRadars(20.0F, 40.0F);
  BeamMergeOptions options;
  EXPECT_TRUE(MergeAt(radars, 0.0, options).ancillary.age.empty());
  options.ancillary = true;
  for (PolarSweep& sweep : radars[1].sweeps)
  {
    for (PolarRay& ray : sweep.rays)
    {
      ray.time += Duration(30'000);
    }
  }
  const GriddedVolume volume = MergeAt(radars, 100.0, options);
  const AncillaryArrays& ancillary = volume.ancillary;
  ASSERT_EQ(volume.sites, (std::vector<std::string>{"KEST", "KWST"}));
  const auto check = [&](std::size_t index, double west, double east)
  {
    ASSERT_EQ(ancillary.radars[index], 2);
    ASSERT_NEAR(ancillary.age[index], 70.0, 1e-3); // of the newer
    ASSERT_WITHIN(ancillary.weight[index],
      std::exp(-west * west / 1e10) + std::exp(-east * east / 1e10), 0.0017,
      "weight of two radars");
    ASSERT_TRUE(
      std::abs(west - east) < 500.0 || ancillary.nearestSite[index] == (east < west ? 0 : 1));
  };
  ForEachOverlap(volume.grid, check);
  for (std::size_t i = 0; i < volume.states.size(); ++i)
  {
    const bool scanned = volume.states[i] != VoxelState::NotScanned;
    ASSERT_EQ(ancillary.radars[i] > 0, scanned);
    ASSERT_EQ(ancillary.nearestSite[i] < 2, scanned);
  }
}

TEST(BeamOverlap, TheResultDoesNotDependOnHowTheRowsAreRun)
{
  const std::vector<PolarVolume> radars = TwoRadars(20.0F, 40.0F);
  const std::vector<const PolarVolume*> pointers = {&radars[0], &radars[1]};
  const RangeLoop backwards = [](int count, const std::function<void(int, int)>& work)
  {
    for (int i = count; i-- > 0;)
    {
      work(i, i + 1);
    }
  };
  const auto merge = [](const std::vector<const PolarVolume*>& volumes, const RangeLoop& loop)
  {
    BeamMerger merger(SceneGrid());
    return MergePolar(merger, volumes, sceneTime, loop);
  };
  const auto once = merge(pointers, {});
  for (const RangeLoop& loop : {backwards, ThreadLoop(1), ThreadLoop(2), ThreadLoop(7)})
  {
    const auto again = merge(pointers, loop);
    EXPECT_EQ(again->values, once->values);
    EXPECT_EQ(again->states, once->states);
  }
  // The order in which the volumes come makes no difference either.
  const auto turned = merge({&radars[1], &radars[0]}, {});
  EXPECT_EQ(turned->values, once->values);
}

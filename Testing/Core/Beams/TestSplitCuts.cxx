// SPDX-License-Identifier: BSD-3-Clause
// Which cuts reflectivity is taken from, and how far each of them tells something.
#include "BeamScene.h"
#include "TestData.h"
#include "Tolerance.h"
#include "nexrad/Level2/Level2File.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>
#include <limits>

using namespace nexrad;
using namespace nexrad::testing;

namespace
{

// A full sweep at one tilt with gates of 1 km.
NumberSweep MakeCut(int number, Waveform waveform, std::size_t gates, float value, double seconds,
  double range = 466'000.0)
{
  NumberSweep sweep = MakeSweep(number, 0.5, 360, gates);
  SetAll(sweep, value);
  sweep.waveform = waveform;
  for (PolarRay& ray : sweep.rays)
  {
    ray.time = sceneTime + Duration(std::llround(seconds * 1000.0));
    ray.unambiguousRange = range;
  }
  return sweep;
}

NumberSweep Limited(const NumberSweep& numbers)
{
  PolarSweep sweep = numbers;
  LimitReach(sweep);
  return NumbersOf(sweep);
}

// The value at the site's own height over the antenna's level, `kilometres` to the east.
float ValueEast(const GriddedVolume& volume, int kilometres)
{
  float value = std::numeric_limits<float>::quiet_NaN();
  const auto x = static_cast<std::size_t>(30 + kilometres / 5);
  for (std::size_t z = 0; z < 72 && std::isnan(value); ++z)
  {
    const std::size_t index = (z * 61 + 30) * 61 + x;
    value = volume.states[index] == VoxelState::Echo ? volume.values[index] : value;
  }
  return value;
}

constexpr Waveform surveillance = Waveform::ContiguousSurveillance;
constexpr Waveform doppler = Waveform::ContiguousDoppler;
constexpr Waveform dopplerWithout = Waveform::ContiguousDopplerWithout;

// A grid of `columns` columns of 2.5 km to either side of a real radar, up to 5 km.
GridSpecification GridAbout(const Site& site, int columns)
{
  GridSpecification grid;
  grid.dimensions = {2 * columns + 1, 2 * columns + 1, 20};
  grid.spacing = {2'500.0, 2'500.0, 250.0};
  grid.origin = {-2'500.0 * columns, -2'500.0 * columns, 250.0};
  grid.centreLatitude = site.position->latitude;
  grid.centreLongitude = site.position->longitude;
  return grid;
}

} // namespace

// Both halves of KVWX's split cut reach as far; the Doppler half came last.
TEST(SplitCuts, ADopplerHalfThatReachesAsFarIsLeftOut)
{
  const std::vector<PolarVolume> volumes = {VolumeOf(
    {MakeCut(1, surveillance, 230, 20.0F, 0.0), MakeCut(2, doppler, 230, 50.0F, 30.0, 148'000.0),
      MakeCut(3, dopplerWithout, 230, 50.0F, 50.0, 137'000.0)})};
  for (const double seconds : {-10.0, 10.0, 40.0, 60.0})
  {
    EXPECT_EQ(ValueEast(MergeAt(volumes, seconds, AsMeasured()), 100), 20.0F) << seconds;
  }
  PolarVolume velocity = volumes[0];
  velocity.moment = MomentName::VEL;
  EXPECT_EQ(ValueEast(MergeAt({velocity}, 60.0, AsMeasured()), 100), 50.0F);
}

TEST(SplitCuts, ADopplerHalfServesWhereItsSurveillanceHalfHasNoRays)
{
  NumberSweep first = MakeCut(1, surveillance, 230, 20.0F, 0.0);
  first.rays.erase(first.rays.begin() + 60, first.rays.begin() + 120); // east is at 90°
  first.values.resize(first.rays.size() * first.gates);
  first.states.resize(first.rays.size() * first.gates);
  const NumberSweep second = MakeCut(2, doppler, 230, 50.0F, 30.0);
  const NumberSweep higher = MakeCut(3, doppler, 230, 50.0F, 30.0);
  const BeamVolume prepared = PrepareBeamVolume(VolumeOf({first, second}));
  ASSERT_EQ(prepared.sweeps.size(), 2U);
  // What is left of it, and its first and last rays again: those beside the gap are near enough.
  EXPECT_EQ(prepared.sweeps[1].azimuths.size(), 60U + 2U);
  EXPECT_EQ(ValueEast(MergeAt({VolumeOf({first, second})}, 40.0, AsMeasured()), 100), 50.0F);
  EXPECT_EQ(ValueEast(MergeAt({VolumeOf({first, second})}, 40.0, AsMeasured()), -100), 20.0F);
  // Alone it serves everywhere; a cut of another tilt between them makes two of them.
  EXPECT_EQ(PrepareBeamVolume(VolumeOf({second})).sweeps.size(), 1U);
  NumberSweep between = MakeCut(2, surveillance, 230, 20.0F, 0.0);
  for (PolarRay& ray : between.rays)
  {
    ray.elevation = 1.5;
  }
  EXPECT_EQ(
    PrepareBeamVolume(VolumeOf({first, between, higher})).sweeps.back().azimuths.size(), 360U + 2U);
}

// As TDAL scans: one cut of long range, then the same tilt each minute to 89 km.
TEST(SplitCuts, ATerminalRadarsShortCutsServeWithinAndItsLongCutBeyond)
{
  const auto volumeAt = [](double seconds, float far)
  {
    PolarVolume volume = VolumeOf({MakeCut(1, surveillance, 230, far, seconds),
      MakeCut(2, dopplerWithout, 89, far + 10.0F, seconds + 20.0, 90'500.0),
      MakeCut(6, dopplerWithout, 89, far + 20.0F, seconds + 80.0, 90'500.0)});
    volume.site.name = "TDAL";
    return volume;
  };
  const std::vector<PolarVolume> volumes = {volumeAt(0.0, 10.0F), volumeAt(300.0, 40.0F)};
  const auto at = [&volumes](double seconds) { return MergeAt(volumes, seconds, AsMeasured()); };
  EXPECT_NEAR(ValueEast(at(50.0), 50), 25.0F, 1e-3F);   // between two short cuts
  EXPECT_NEAR(ValueEast(at(50.0), 120), 15.0F, 1e-3F);  // long cuts, 50 s and 250 s away
  EXPECT_NEAR(ValueEast(at(-10.0), 50), 10.0F, 1e-3F);  // after it, the long cut comes first
  EXPECT_NEAR(ValueEast(at(10.0), 120), 11.0F, 1e-3F);  // 10 s and 290 s away
  EXPECT_NEAR(ValueEast(at(350.0), 50), 55.0F, 1e-3F);  // between two short cuts again
  EXPECT_NEAR(ValueEast(at(400.0), 120), 40.0F, 1e-3F); // long cuts lie before alone
  EXPECT_NEAR(ValueEast(at(400.0), 50), 60.0F, 1e-3F);
}

// No echo above the weather is assumed beyond the last gate; what another cut measured there counts
// before that.
TEST(SplitCuts, WhatALongerCutMeasuredCountsBeforeWhatIsAssumed)
{
  NumberSweep longer = MakeCut(1, dopplerWithout, 80, 30.0F, 0.0);
  NumberSweep shorter = MakeCut(2, dopplerWithout, 40, 30.0F, 20.0);
  for (NumberSweep* sweep : {&longer, &shorter})
  {
    for (PolarRay& ray : sweep->rays)
    {
      ray.elevation = 19.5;
    }
  }
  PolarVolume volume = VolumeOf({longer, shorter});
  volume.site.name = "TDAL";
  GridSpecification grid = SceneGrid();
  grid.dimensions[2] = 120;
  for (const double seconds : {-10.0, 30.0})
  {
    const GriddedVolume merged = MergeAt({volume}, seconds, AsMeasured(), grid);
    std::size_t high = 0;
    const auto check = [&](const SeenVoxel& voxel)
    {
      if (std::abs(voxel.elevation - 19.5) < 0.2 && voxel.slantRange > 60'000.0 &&
          voxel.slantRange < 75'000.0)
      {
        ASSERT_EQ(merged.states[voxel.index], VoxelState::Echo) << voxel.slantRange;
        ++high;
      }
    };
    ForEachVoxel(merged.grid, centralSite, check);
    EXPECT_AT_LEAST(high, 400U, "voxels that the longer cut decides");
  }
}

TEST(SplitCuts, ABeamIsAsWideAsItsRadarsUnlessSaid)
{
  const auto countScanned = [](const std::string& name, std::optional<double> width)
  {
    PolarVolume volume = VolumeOf({UniformSweep(1, 5.0, 20.0F)});
    volume.site.name = name;
    BeamMergeOptions options;
    options.beamWidth = width;
    const std::vector<VoxelState> states = MergeAt({volume}, 0.0, options).states;
    return std::count(states.begin(), states.end(), VoxelState::Echo);
  };
  const auto usual = countScanned("KTLX", std::nullopt);
  const auto terminal = countScanned("TDAL", std::nullopt);
  EXPECT_WITHIN(static_cast<double>(terminal) / static_cast<double>(usual), 0.55 / 0.95, 0.004,
    "voxels of the narrower beam, part of the wider one's");
  EXPECT_EQ(countScanned("TDAL", 0.95), usual);
  EXPECT_EQ(countScanned("KTLX", 0.55), terminal);
}

TEST(SplitCuts, NoEchoBeyondTheUnambiguousRangeIsNotScanned)
{
  NumberSweep sweep = MakeSweep(1, 0.5, 3, 10); // gates at 1 to 10 km
  sweep.waveform = doppler;
  sweep.rays[0].unambiguousRange = 4'000.0;
  sweep.rays[1].unambiguousRange = 6'400.0;
  sweep.rays[2].unambiguousRange = 3'900.0;
  SetGate(sweep, 2, 7, 30.0F); // put there by the radar from where it came back
  sweep.states[sweep.Index(2, 5)] = GateState::RangeFolded;
  NumberSweep batch = sweep;
  batch.waveform = Waveform::Batch;
  NumberSweep unknown = sweep;
  unknown.waveform = Waveform::Unknown;
  sweep = Limited(sweep);
  EXPECT_EQ(sweep.gates, 8U);
  ASSERT_EQ(sweep.states.size(), 24U);
  EXPECT_EQ(sweep.states[sweep.Index(0, 3)], GateState::BelowThreshold);
  EXPECT_EQ(sweep.states[sweep.Index(0, 4)], GateState::NotSampled);
  EXPECT_EQ(sweep.states[sweep.Index(1, 5)], GateState::BelowThreshold);
  EXPECT_EQ(sweep.states[sweep.Index(1, 6)], GateState::NotSampled);
  EXPECT_EQ(sweep.states[sweep.Index(2, 2)], GateState::BelowThreshold);
  EXPECT_EQ(sweep.states[sweep.Index(2, 3)], GateState::NotSampled);
  EXPECT_EQ(sweep.states[sweep.Index(2, 5)], GateState::RangeFolded);
  EXPECT_EQ(sweep.values[sweep.Index(2, 7)], 30.0F);
  for (const NumberSweep& other : {Limited(batch), Limited(unknown)})
  {
    EXPECT_EQ(other.gates, 10U);
    EXPECT_EQ(std::count(other.states.begin(), other.states.end(), GateState::NotSampled), 0);
  }
}

// In the real file the echo south of the radar, up to 50 dBZ and more, lies astride the Doppler
// half's 148 km. Before that half began, and after it ended, there must be as much of it.
TEST(SplitCuts, EchoBeyondTheDopplerHalfStaysAtKVWX)
{
  NEXRAD_REQUIRE_TEST_DATA(data);
  const RadarVolume file = ReadLevel2(data / "level2/legacy/KVWX_20050626_221551.gz");
  const PolarVolume volume = MakePolarVolume(file, MomentName::REF);
  BeamMerger merger(GridAbout(volume.site, 90));
  const BeamVolumes ready = PrepareAll(merger, {&volume});
  std::vector<std::size_t> counts;
  for (const char* time : {"2005-06-26T22:19:12Z", "2005-06-26T22:21:44Z"})
  {
    const auto merged = merger.Merge(ready, *ParseIso8601(time), nullptr, ThreadLoop(2));
    std::size_t count = 0;
    const auto visit = [&](const SeenVoxel& voxel)
    {
      count += voxel.groundDistance > 155'000.0 && merged->values[voxel.index] > 30.0F &&
               merged->states[voxel.index] == VoxelState::Echo;
    };
    ForEachVoxel(merged->grid, *volume.site.position, visit);
    counts.push_back(count);
  }
  EXPECT_AT_LEAST(counts[0], 4'000U, "voxels with echo beyond the Doppler half");
  EXPECT_EQ(counts[1], counts[0]);
}

// Prints how old the lowest voxels of a terminal radar are, minute by minute: the median over the
// columns within 85 km.
TEST(SplitCuts, LowestVoxelsOfTDALAreRenewedEachMinute)
{
  NEXRAD_REQUIRE_TEST_DATA(data);
  const RadarVolume file = ReadLevel2(data / "level2/tdwr/TDAL20191021021543V08.raw.gz");
  const PolarVolume volume = MakePolarVolume(file, MomentName::REF);
  BeamMergeOptions options;
  options.ancillary = true;
  BeamMerger merger(GridAbout(volume.site, 34), options);
  const BeamVolumes ready = PrepareAll(merger, {&volume});
  for (const char* time : {"2019-10-21T02:16:00Z", "2019-10-21T02:16:30Z", "2019-10-21T02:17:00Z",
         "2019-10-21T02:17:30Z", "2019-10-21T02:18:00Z", "2019-10-21T02:18:30Z"})
  {
    const auto merged = merger.Merge(ready, *ParseIso8601(time), nullptr, ThreadLoop(2));
    const auto columns = static_cast<std::size_t>(merged->grid.dimensions[0]) *
                         static_cast<std::size_t>(merged->grid.dimensions[1]);
    std::vector<float> ages(columns, -1.0F);
    const auto visit = [&](const SeenVoxel& voxel)
    {
      const VoxelState state = merged->states[voxel.index];
      float& age = ages[voxel.index % columns];
      if (voxel.groundDistance < 85'000.0 && voxel.index / columns < 8 && age < 0.0F &&
          (state == VoxelState::Echo || state == VoxelState::NoEcho))
      {
        age = merged->ancillary.age[voxel.index];
      }
    };
    // Level by level upwards, so that the lowest comes first.
    ForEachVoxel(merged->grid, *volume.site.position, visit);
    ages.erase(std::remove(ages.begin(), ages.end(), -1.0F), ages.end());
    ASSERT_AT_LEAST(ages.size(), 2000U, "voxels of the lowest level");
    const auto middle = ages.begin() + static_cast<std::ptrdiff_t>(ages.size() / 2);
    std::nth_element(ages.begin(), middle, ages.end());
    std::printf("TDAL %.8s median age of the lowest voxels %5.1f s\n", time + 11,
      static_cast<double>(*middle));
    EXPECT_AT_MOST(*middle, 40.0F, "median age of the lowest voxels, s") << time;
  }
}

// SPDX-License-Identifier: BSD-3-Clause
#include "DirectMerge.h"
#include "nexrad/Grid/MakeGrid.h"
#include "nexrad/Merging/TimeMerge.h"

#include "HandMadeVolume.h"
#include "MovingEcho.h"
#include "Scans/RadarsOfMissouri.h"
#include "SweepMaker.h"
#include "TestData.h"
#include "Tolerance.h"
#include "nexrad/System/Error.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <limits>

namespace nexrad
{
namespace
{

using namespace std::chrono_literals;
using testing::ConstantVolume;
using testing::keax;
using testing::klsx;
using testing::PointersTo;
using testing::start;

PolarVolume Polar(const Site& site, Time time, double reflectivity)
{
  return MakePolarVolume(
    testing::MakeRadarVolume(ConstantVolume(site, time, reflectivity)), MomentName::REF);
}

MergeRequest Request(const std::vector<Position>& sites, Time time)
{
  GridRequest grid;
  grid.dimensions = {32, 32, 8};
  grid.range = 100'000.0;
  MergeRequest request;
  request.grid = MakeGrid(grid, sites);
  request.time = time;
  request.method = MergeMethod::Thesis;
  return request;
}

/// Smallest and largest value of the voxels with an echo.
std::pair<float, float> EchoRange(const GriddedVolume& volume)
{
  std::pair<float, float> range = {1000.0F, -1000.0F};
  for (std::size_t i = 0; i < volume.values.size(); ++i)
  {
    if (volume.states[i] == VoxelState::Echo)
    {
      range.first = std::min(range.first, volume.values[i]);
      range.second = std::max(range.second, volume.values[i]);
    }
  }
  return range;
}

void ExpectEcho(const GriddedVolume& volume, float value)
{
  const auto [smallest, largest] = EchoRange(volume);
  EXPECT_NEAR(smallest, value, 1e-3F);
  EXPECT_NEAR(largest, value, 1e-3F);
}

TEST(TimeMerge, InterpolatesBetweenTheVolumesAboutTheTime)
{
  // In no order: 10, 20 and 40 dBZ at 18:00, 18:05 and 18:10.
  const PolarVolume last = Polar(keax, start + 10min, 40.0);
  const PolarVolume first = Polar(keax, start, 10.0);
  const PolarVolume middle = Polar(keax, start + 5min, 20.0);
  const std::vector<const PolarVolume*> volumes = {&last, &first, &middle};
  const auto at = [&](Duration after)
  { return *testing::MergeDirectly(volumes, Request({*keax.position}, start + after)); };
  ExpectEcho(at(0min), 10.0F);
  ExpectEcho(at(2min), 14.0F);
  ExpectEcho(at(5min), 20.0F);
  ExpectEcho(at(9min), 36.0F);
  ExpectEcho(at(20min), 40.0F);  // one side alone, unchanged
  ExpectEcho(at(-10min), 10.0F); // likewise
}

TEST(TimeMerge, VolumesBeyondTheGapTakeNoPart)
{
  const PolarVolume volume = Polar(keax, start, 30.0);
  MergeRequest request = Request({*keax.position}, start + 16min);
  const auto none = testing::MergeDirectly({&volume}, request);
  ASSERT_TRUE(none);
  EXPECT_TRUE(none->sites.empty());
  EXPECT_TRUE(std::all_of(none->states.begin(), none->states.end(),
    [](VoxelState state) { return state == VoxelState::NotScanned; }));
  request.maximumGap = 16min;
  ExpectEcho(*testing::MergeDirectly({&volume}, request), 30.0F);
}

// A picture of it must say so; another volume of the radar fills up what is missing.
TEST(TimeMerge, AVolumeThatWasCutOffIsNoted)
{
  RadarVolume decoded = testing::MakeRadarVolume(ConstantVolume(keax, start, 30.0));
  EXPECT_FALSE(MakePolarVolume(decoded, MomentName::REF).endsAt);
  decoded.cuts.emplace_back(); // whose end is missing
  const PolarVolume cutOff = MakePolarVolume(decoded, MomentName::REF);
  ASSERT_TRUE(cutOff.endsAt);
  EXPECT_NEAR(*cutOff.endsAt, MedianElevation(cutOff.sweeps.back()), 1e-6);
  decoded.cuts.back().excerpt = true;
  EXPECT_FALSE(MakePolarVolume(decoded, MomentName::REF).endsAt) << "cut off on purpose";
  MergeRequest request = Request({*keax.position}, start);
  request.method = MergeMethod::Beam;
  const auto alone = testing::MergeDirectly({&cutOff}, request);
  ASSERT_EQ(alone->notes.size(), 1U);
  EXPECT_EQ(alone->notes[0].find("KEAX: volume ends at 0.5°, cut off"), 0U) << alone->notes[0];
  const PolarVolume whole = Polar(keax, start + 5min, 30.0);
  EXPECT_TRUE(testing::MergeDirectly({&cutOff, &whole}, request)->notes.empty());
}

TEST(TimeMerge, EachSiteHasItsOwnBracket)
{
  const PolarVolume before = Polar(keax, start, 10.0);
  const PolarVolume after = Polar(keax, start + 4min, 20.0);
  const PolarVolume other = Polar(klsx, start + 1min, 50.0);
  const auto merged = testing::MergeDirectly(
    {&other, &after, &before}, Request({*keax.position, *klsx.position}, start + 2min));
  EXPECT_EQ(merged->sites, (std::vector<std::string>{"KEAX", "KLSX"}));
  // The circles of 100 km do not meet: 310 km lie between the radars.
  EXPECT_NEAR(EchoRange(*merged).first, 15.0F, 1e-3F);
  EXPECT_NEAR(EchoRange(*merged).second, 50.0F, 1e-3F);
}

// Two radars that scan moving storms for a quarter of an hour.
std::vector<PolarVolume> ScanStorms(MomentName moment = MomentName::REF)
{
  testing::MovingEcho field;
  field.storms = {{30e3, 40e3, 50.0}, {-60e3, -30e3, 45.0}, {-20e3, 60e3, 55.0}};
  field.velocity = {20.0, 10.0};
  std::vector<PolarVolume> volumes;
  for (const double seconds : {0.0, 300.0, 600.0})
  {
    volumes.push_back(testing::ScanEcho(field, keax, start, seconds));
    volumes.push_back(testing::ScanEcho(field, klsx, start, seconds + 80.0));
  }
  for (PolarVolume& volume : volumes)
  {
    volume.moment = moment;
  }
  return volumes;
}

MergeRequest BeamRequest(Duration after)
{
  MergeRequest request = Request({*keax.position, *klsx.position}, start + after);
  request.grid.dimensions[2] = 4;
  request.method = MergeMethod::Beam;
  return request;
}

// A run that comes to a time through others, as one process of several does not, and volumes in
// another order, give the same bytes.
TEST(TimeMerge, MotionDoesNotDependOnWhatWasMergedBefore)
{
  const std::vector<PolarVolume> volumes = ScanStorms();
  std::vector<const PolarVolume*> pointers = PointersTo(volumes);
  testing::DirectRun run;
  for (const Duration after : {Duration(20s), Duration(4min), Duration(11min), Duration(8min),
         Duration(14min), Duration(4min)})
  {
    const auto ofRun = testing::MergeDirectly(pointers, BeamRequest(after), {}, &run);
    const auto fresh = testing::MergeDirectly(pointers, BeamRequest(after));
    EXPECT_EQ(ofRun->values, fresh->values);
    EXPECT_EQ(ofRun->states, fresh->states);
    std::reverse(pointers.begin(), pointers.end());
  }
}

// Between the volumes, in the first one, and minutes before the first and after the last.
class MotionAt : public ::testing::TestWithParam<Duration>
{
};

TEST_P(MotionAt, IsTheDefaultAndCanBeGivenOrLeft)
{
  const std::vector<PolarVolume> volumes = ScanStorms();
  MergeRequest request = BeamRequest(GetParam());
  const auto found = testing::MergeDirectly(PointersTo(volumes), request);
  request.motion = Velocity{20.0, 10.0};
  const auto given = testing::MergeDirectly(PointersTo(volumes), request);
  request.interpolation = TimeInterpolationMethod::Linear;
  const auto linear = testing::MergeDirectly(PointersTo(volumes), request);
  // What is found is nearer to what is known than to nothing.
  double ofFound = 0.0;
  double ofLinear = 0.0;
  for (std::size_t i = 0; i < given->values.size(); ++i)
  {
    if (given->states[i] == VoxelState::Echo)
    {
      const auto off = [&](const GriddedVolume& volume)
      {
        const bool echo = volume.states[i] == VoxelState::Echo;
        return std::abs(static_cast<double>(given->values[i] - (echo ? volume.values[i] : 0.0F)));
      };
      ofFound += off(*found);
      ofLinear += off(*linear);
    }
  }
  EXPECT_AT_LEAST(ofLinear, 120.0, "error of the linear interpolation, dBZ summed over the voxels");
  EXPECT_AT_MOST(ofFound / ofLinear, 0.055,
    "error along the motion found, part of that of the linear interpolation");
}

INSTANTIATE_TEST_SUITE_P(TimeMerge, MotionAt,
  ::testing::Values(Duration(-3min), Duration(20s), Duration(4min), Duration(15min)));

TEST(TimeMerge, OtherMomentsMoveOnlyAsGiven)
{
  const std::vector<PolarVolume> volumes = ScanStorms(MomentName::ZDR);
  MergeRequest request = BeamRequest(4min);
  const auto alone = testing::MergeDirectly(PointersTo(volumes), request);
  request.interpolation = TimeInterpolationMethod::Linear;
  EXPECT_EQ(testing::MergeDirectly(PointersTo(volumes), request)->values, alone->values);
  request.interpolation = TimeInterpolationMethod::AlongMotion;
  request.motion = Velocity{20.0, 10.0};
  EXPECT_NE(testing::MergeDirectly(PointersTo(volumes), request)->values, alone->values);
}

TEST(TimeMerge, RefusesAMotionFasterThanAnyEcho)
{
  const std::vector<PolarVolume> volumes = ScanStorms();
  MergeRequest request = BeamRequest(4min);
  for (const double bad : {200.0, std::numeric_limits<double>::quiet_NaN()})
  {
    request.motion = Velocity{0.0, bad};
    EXPECT_THROW(testing::MergeDirectly(PointersTo(volumes), request), Error);
  }
}

TEST(TimeMerge, ARunMakesANewMergerForOtherOptions)
{
  MergeRun run;
  MergeRequest request = Request({*keax.position}, start);
  const BeamMerger* first = &run.MergerFor(request);
  EXPECT_EQ(&run.MergerFor(request), first);
  request.time += 5min;
  EXPECT_EQ(&run.MergerFor(request), first);
  request.beam.fillColumns = true;
  EXPECT_TRUE(run.MergerFor(request).Options().fillColumns);
  request.grid.dimensions = {16, 16, 4};
  EXPECT_EQ(run.MergerFor(request).Grid().dimensions[0], 16);
}

TEST(TimeMerge, StopsWhenAskedTo)
{
  const PolarVolume volume = Polar(keax, start, 30.0);
  EXPECT_FALSE(testing::MergeDirectly(
    {&volume}, Request({*keax.position}, start), [](double) { return false; }));
}

} // namespace
} // namespace nexrad

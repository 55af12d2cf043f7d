// SPDX-License-Identifier: BSD-3-Clause
// Formulas A3a: what short volumes, and volumes near in time, tell of the motion. The synthetic
// storms lean: above 1.5° they stand farther west, as those of a sheared wind do.
#include "nexrad/Grid/MakeGrid.h"
#include "nexrad/Level2/Level2File.h"
#include "nexrad/Motion/MotionTracker.h"

#include "MovingEcho.h"
#include "ReadyVolume.h"
#include "TestData.h"
#include "Tolerance.h"

#include <gtest/gtest.h>

#include <algorithm>

using namespace nexrad;
using namespace nexrad::testing;
using namespace std::chrono_literals;

namespace
{

const Site site = {"KWST", Position{38.7, -92.0, 200.0}};
const Velocity velocity = {11.0, -3.0};
constexpr double lean = 8'000.0; // m
constexpr double secondsPerSweep = 20.0;

// The tilts from `first` up to `end`, in the order scanned, of a volume that starts `start` s after
// zero; all storms `east` m farther east.
std::shared_ptr<const BeamVolume> Scan(double start, std::size_t first, std::size_t end,
  const Velocity& motion = velocity, double east = 0.0)
{
  const std::vector<double> tilts = {0.5, 0.9, 1.3, 1.8, 2.4, 3.1, 4.0, 5.1, 6.4, 8.0, 10.0, 12.5};
  MovingEcho field;
  field.storms = {
    {20e3, 40e3, 45.0}, {-60e3, -30e3, 40.0}, {70e3, -40e3, 45.0}, {-20e3, 80e3, 40.0}};
  field.velocity = motion;
  for (MovingEcho::Storm& storm : field.storms)
  {
    storm.east += east;
  }
  MovingEcho aloft = field;
  for (MovingEcho::Storm& storm : aloft.storms)
  {
    storm.east -= lean;
    storm.dbz += 10.0;
  }
  PolarVolume all;
  for (std::size_t i = first; i < std::min(end, tilts.size()); ++i)
  {
    ScanPlan plan;
    plan.tilts = {tilts[i]};
    plan.secondsPerSweep = secondsPerSweep;
    PolarVolume one = ScanEcho(tilts[i] < 1.5 ? field : aloft, site, zero,
      start + secondsPerSweep * static_cast<double>(i - first), plan);
    one.sweeps.front().elevationNumber = static_cast<int>(i) + 1;
    if (all.sweeps.empty())
    {
      all = one;
    }
    else
    {
      all.sweeps.push_back(one.sweeps.front());
      all.end = one.end;
    }
  }
  return Ready(all);
}

GridSpecification GridOfOneRadar()
{
  GridRequest request;
  request.dimensions = {96, 96, 4};
  request.range = 130'000.0;
  return MakeGrid(request, {*site.position});
}

// The largest error of the motion that the volumes give, m/s.
double ErrorOf(const BeamVolumes& volumes, Time time, const Velocity& motion = velocity)
{
  const auto field = MotionTracker(GridOfOneRadar()).Find(volumes, time);
  if (!field)
  {
    return std::hypot(motion.east, motion.north); // nothing moves
  }
  double largest = 0.0;
  for (const Velocity& found : field->velocities)
  {
    largest = std::max(largest, std::hypot(found.east - motion.east, found.north - motion.north));
  }
  return largest;
}

double FastestIn(const BeamVolumes& volumes, Time time)
{
  const auto field = MotionTracker(GridOfOneRadar()).Find(volumes, time);
  return field ? field->FastestSpeed() : 0.0;
}

constexpr std::size_t allTilts = 12;

} // namespace

// A radar starts its volume again after one to three low tilts: the strongest echo of these and of
// the whole volume is that of other heights.
TEST(MotionTimeBase, AVolumeThatStartsAgainMovesNoFaster)
{
  for (const std::size_t tilts : {1U, 2U, 3U})
  {
    const BeamVolumes volumes = {Scan(-160.0, 0, tilts), Scan(0.0, 0, allTilts)};
    EXPECT_AT_MOST(FastestIn(volumes, zero + 60s), 4.0, "fastest motion, m/s");
  }
}

TEST(MotionTimeBase, AVolumeThatEndsEarlyMovesNoFaster)
{
  for (const std::size_t tilts : {1U, 2U, 3U})
  {
    const BeamVolumes volumes = {Scan(-240.0, 0, allTilts), Scan(0.0, 0, tilts)};
    EXPECT_AT_MOST(FastestIn(volumes, zero + 10s), 9.0, "fastest motion, m/s");
  }
}

// Whole volumes on both sides tell more than the short one between them.
TEST(MotionTimeBase, WholeVolumesAboutAShortOneAreCompared)
{
  const auto before = Scan(-400.0, 0, allTilts);
  const auto fragment = Scan(-160.0, 0, 2);
  const auto after = Scan(0.0, 0, allTilts);
  EXPECT_AT_MOST(ErrorOf({before, fragment, after}, zero + 20s), 1.0, "error of the motion, m/s");
}

// Nothing that both saw: the echo is not moved.
TEST(MotionTimeBase, VolumesWithoutACommonHeightTellNothing)
{
  const BeamVolumes volumes = {Scan(-160.0, 0, 2), Scan(0.0, 4, allTilts)};
  EXPECT_FALSE(MotionTracker(GridOfOneRadar()).Find(volumes, zero));
}

// The error of a displacement, here 500 m, is no speed of 50 m/s because it was found in 10 s.
TEST(MotionTimeBase, VolumesNearInTimeDoNotMakeEchoFast)
{
  const auto first = Scan(-10.0, 0, allTilts, {0.0, 0.0});
  const auto second = Scan(0.0, 0, allTilts, {0.0, 0.0}, 500.0);
  const auto motion = MotionTracker(GridOfOneRadar()).Find({first, second}, zero);
  ASSERT_TRUE(motion);
  EXPECT_AT_MOST(motion->FastestSpeed(), 0.3, "fastest motion, m/s");
}

// Volumes a minute apart: those three minutes apart are compared.
TEST(MotionTimeBase, OfVolumesEachMinuteThoseFartherApartAreCompared)
{
  BeamVolumes volumes;
  for (const double start : {-180.0, -120.0, -60.0, 0.0})
  {
    volumes.push_back(Scan(start, 0, 3));
  }
  const auto found = MotionTracker(GridOfOneRadar()).Find(volumes, zero - 40s);
  const auto expected =
    MotionTracker(GridOfOneRadar()).Find({volumes.front(), volumes.back()}, zero - 40s);
  ASSERT_TRUE(found && expected);
  EXPECT_EQ(found->At(40.0, 40.0).east, expected->At(40.0, 40.0).east);
  EXPECT_AT_MOST(ErrorOf(volumes, zero - 40s), 1.0, "error of the motion, m/s");
}

TEST(MotionTimeBase, FastStormsStayFast)
{
  const Velocity fast = {28.0, 12.0};
  const BeamVolumes volumes = {Scan(-260.0, 0, allTilts, fast), Scan(0.0, 0, allTilts, fast)};
  EXPECT_AT_MOST(ErrorOf(volumes, zero, fast), 1.5, "error of the motion, m/s");
}

// Two real low tilts, and the new volume that the radar began 2.6 minutes later. Between the low
// tilts the echo moves with 11 m/s to the east and 3 m/s to the south.
TEST(MotionTimeBase, ARealVolumeThatStartsAgain)
{
  NEXRAD_REQUIRE_TEST_DATA(data);
  const std::filesystem::path day = data / "reports" / "radar" / "restart-motion" / "day";
  BeamVolumes volumes;
  for (const char* name : {"KSRX20200805_154019_V06", "KSRX20200805_154258_V06"})
  {
    volumes.push_back(Ready(MakePolarVolume(ReadLevel2(day / name), MomentName::REF)));
  }
  GridRequest request;
  request.dimensions = {600, 600, 3};
  request.range = 150'000.0;
  const GridSpecification grid = MakeGrid(request, {volumes.front()->site.position.value()});
  const auto motion = MotionTracker(grid).Find(volumes, *ParseIso8601("2020-08-05T15:44:00Z"));
  ASSERT_TRUE(motion);
  EXPECT_AT_MOST(motion->FastestSpeed(), 11.0, "fastest motion, m/s");
}

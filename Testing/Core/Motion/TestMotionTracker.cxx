// SPDX-License-Identifier: BSD-3-Clause
// Formulas A3a: the motion that is found from what radars scanned, held against that of synthetic
// storms.
#include "nexrad/Grid/MakeGrid.h"
#include "nexrad/Motion/MotionTracker.h"

#include "MovingEcho.h"
#include "ReadyVolume.h"
#include "Tolerance.h"

#include <gtest/gtest.h>

#include <algorithm>

using namespace nexrad;
using namespace nexrad::testing;
using namespace std::chrono_literals;

namespace
{

const Site west = {"KWST", Position{38.7, -92.0, 200.0}};
const Site east = {"KEST", Position{38.7, -91.0, 300.0}};
constexpr double apart = 87e3; // m, the eastern radar from the western one

MovingEcho TestField(const Velocity& velocity)
{
  MovingEcho field;
  field.storms = {{20e3, 40e3, 50.0}, {-60e3, -30e3, 45.0}, {70e3, -40e3, 55.0},
    {110e3, 50e3, 48.0}, {150e3, -10e3, 52.0}};
  field.velocity = velocity;
  return field;
}

// Of each radar three volumes, 250 s apart; the eastern one looks 100 s later.
BeamVolumes Scan(const MovingEcho& field)
{
  BeamVolumes volumes;
  for (const double start : {-320.0, -70.0, 180.0})
  {
    volumes.push_back(Ready(ScanEcho(field, west, zero, start)));
    volumes.push_back(Ready(ScanEcho(field, east, zero, start + 100.0, {}, apart, 0.0)));
  }
  return volumes;
}

GridSpecification TestGrid()
{
  GridRequest request;
  request.dimensions = {96, 80, 4};
  request.range = 130'000.0;
  return MakeGrid(request, {*west.position, *east.position});
}

void ExpectSame(const MotionField& a, const MotionField& b)
{
  ASSERT_EQ(a.velocities.size(), b.velocities.size());
  for (std::size_t i = 0; i < a.velocities.size(); ++i)
  {
    ASSERT_EQ(a.velocities[i].east, b.velocities[i].east);
    ASSERT_EQ(a.velocities[i].north, b.velocities[i].north);
  }
}

} // namespace

TEST(MotionTracker, FindsOneMotionForTwoRadars)
{
  for (const Velocity& velocity : {Velocity{18.0, 7.0}, Velocity{-9.0, -14.0}, Velocity{0.0, 30.0}})
  {
    MotionTracker tracker(TestGrid());
    const auto motion = tracker.Find(Scan(TestField(velocity)), zero);
    ASSERT_TRUE(motion);
    EXPECT_TRUE(motion->Covers(TestGrid()));
    for (const Velocity& found : motion->velocities)
    {
      EXPECT_AT_MOST(std::hypot(found.east - velocity.east, found.north - velocity.north), 0.9,
        "error of the motion, m/s");
    }
  }
}

// The storms are followed one by one: the motion of an area is that of the storm in it.
TEST(MotionTracker, FindsTheMotionOfTheEchoInAnArea)
{
  const GridSpecification grid = TestGrid();
  MotionTracker tracker(grid);
  const Velocity velocity = {18.0, 7.0};
  const BeamVolumes volumes = Scan(TestField(velocity));
  for (const std::array<double, 2>& storm :
    {std::array{-91.77, 39.06}, std::array{-92.69, 38.43}, std::array{-90.73, 39.15}})
  {
    const auto [x, y] = grid.FromGeographic(storm[0], storm[1]);
    const auto found = tracker.FindWithin({x - 20e3, x + 20e3, y - 20e3, y + 20e3}, volumes, zero);
    ASSERT_TRUE(found);
    EXPECT_AT_MOST(std::hypot(found->east - velocity.east, found->north - velocity.north), 0.6,
      "error of the motion in an area, m/s");
  }
  const auto [x, y] = grid.FromGeographic(-92.0, 37.8);
  const auto empty = tracker.FindWithin({x - 5e3, x + 5e3, y - 5e3, y + 5e3}, volumes, zero);
  ASSERT_TRUE(empty);
  EXPECT_AT_MOST(std::hypot(empty->east - velocity.east, empty->north - velocity.north), 0.45,
    "error of the motion in an area without echo, m/s");
  EXPECT_FALSE(tracker.FindWithin({x, x + 5e3, y, y + 5e3}, {}, zero));
}

TEST(MotionTracker, IsStillWhereNothingMoves)
{
  MotionTracker tracker(TestGrid());
  const auto motion = tracker.Find(Scan(TestField({0.0, 0.0})), zero);
  ASSERT_TRUE(motion);
  EXPECT_LT(motion->FastestSpeed(), 1e-6);
}

// A run that starts in the middle of the day finds what one finds that has come there.
TEST(MotionTracker, DependsOnTheVolumesAndTheTimeAlone)
{
  BeamVolumes volumes = Scan(TestField({18.0, 7.0}));
  MotionTracker run(TestGrid());
  const auto first = run.Find(volumes, zero - 60s);
  const auto second = run.Find(volumes, zero + 100s, ThreadLoop(7));
  EXPECT_NE(first, second); // other volumes stand about the time
  std::reverse(volumes.begin(), volumes.end());
  const auto again = run.Find(volumes, zero - 60s, ThreadLoop(2));
  ExpectSame(*first, *again);
  ExpectSame(*second, *MotionTracker(TestGrid()).Find(volumes, zero + 100s));
}

TEST(MotionTracker, KeepsTheMotionWhileTheVolumesStay)
{
  const BeamVolumes volumes = Scan(TestField({18.0, 7.0}));
  MotionTracker run(TestGrid());
  const auto first = run.Find(volumes, zero);
  EXPECT_EQ(run.Find(volumes, zero + 10s), first);
}

// Before the middles of the first volumes, and after those of the last, no motion is known: the
// nearest that is known serves.
TEST(MotionTracker, TheNearestMotionServesBeyondTheMiddles)
{
  BeamVolumes volumes = Scan(TestField({18.0, 7.0}));
  const auto first = MotionTracker(TestGrid()).Find(volumes, zero - 100s);
  const auto last = MotionTracker(TestGrid()).Find(volumes, zero + 200s);
  ASSERT_TRUE(first && last);
  for (const Duration early : {Duration(-200s), Duration(-300s), Duration(-600s)})
  {
    const auto found = MotionTracker(TestGrid()).Find(volumes, zero + early);
    ASSERT_TRUE(found) << early / 1s;
    ExpectSame(*found, *first);
  }
  std::reverse(volumes.begin(), volumes.end());
  for (const Duration late : {Duration(260s), Duration(400s), Duration(900s)})
  {
    const auto found = MotionTracker(TestGrid()).Find(volumes, zero + late);
    ASSERT_TRUE(found) << late / 1s;
    ExpectSame(*found, *last);
  }
}

// Volumes that lie too far apart tell nothing about the motion between them; their neighbours do.
TEST(MotionTracker, TheNearestMotionServesWhereARadarMissedVolumes)
{
  const MovingEcho field = TestField({18.0, 7.0});
  BeamVolumes volumes;
  for (const double start : {-1'200.0, -900.0, 600.0, 900.0})
  {
    volumes.push_back(Ready(ScanEcho(field, west, zero, start)));
  }
  for (const Duration time : {Duration(-600s), Duration(300s)})
  {
    const auto motion = MotionTracker(TestGrid()).Find(volumes, zero + time);
    ASSERT_TRUE(motion) << time / 1s;
    const std::size_t from = time < Duration::zero() ? 0 : 2;
    const auto expected =
      MotionTracker(TestGrid()).Find({volumes[from], volumes[from + 1]}, zero + time);
    ASSERT_TRUE(expected);
    ExpectSame(*motion, *expected);
  }
}

TEST(MotionTracker, KnowsNothingWithoutTwoVolumesWithEchoNearEachOther)
{
  const MovingEcho field = TestField({18.0, 7.0});
  const auto volume = Ready(ScanEcho(field, west, zero, -320.0));
  const auto late = Ready(ScanEcho(field, west, zero, 1'000.0));
  const auto empty = Ready(ScanEcho({}, west, zero, 100.0));
  MotionTracker tracker(TestGrid());
  EXPECT_FALSE(tracker.Find({}, zero));
  EXPECT_FALSE(tracker.Find({volume}, zero));
  EXPECT_FALSE(tracker.Find({volume, late}, zero)); // 22 minutes apart
  EXPECT_FALSE(tracker.Find({volume, empty}, zero));
  const auto after = Ready(ScanEcho(field, west, zero, 100.0));
  EXPECT_TRUE(tracker.Find({volume, after}, zero));
}

// A site's name tells it from others; a file may store its position rounded, or after the antenna
// moved.
TEST(MotionTracker, ARadarIsTheSameWhenItsStoredPositionDiffersALittle)
{
  const Velocity velocity = {18.0, 7.0};
  const MovingEcho field = TestField(velocity);
  Site moved = west;
  moved.position->latitude += 0.0005; // 56 m
  moved.position->altitude += 10.0;
  const auto before = Ready(ScanEcho(field, west, zero, -320.0));
  const auto after = Ready(ScanEcho(field, moved, zero, 100.0));
  const auto motion = MotionTracker(TestGrid()).Find({before, after}, zero);
  ASSERT_TRUE(motion);
  for (const Velocity& found : motion->velocities)
  {
    EXPECT_AT_MOST(std::hypot(found.east - velocity.east, found.north - velocity.north), 0.9,
      "error of the motion, m/s");
  }
  Site other = moved;
  other.name = "KABC";
  const auto ofOther = Ready(ScanEcho(field, other, zero, 100.0));
  EXPECT_FALSE(MotionTracker(TestGrid()).Find({before, ofOther}, zero));
}

// A radar outside the grid has nothing to say, and does no harm.
TEST(MotionTracker, TakesNoHarmFromARadarOutsideTheGrid)
{
  const MovingEcho field = TestField({18.0, 7.0});
  BeamVolumes volumes = Scan(field);
  const auto known = MotionTracker(TestGrid()).Find(volumes, zero);
  const Site far = {"KABC", Position{20.0, -60.0, 0.0}};
  volumes.insert(volumes.begin(), Ready(ScanEcho(field, far, zero, -320.0)));
  volumes.push_back(Ready(ScanEcho(field, far, zero, 100.0)));
  const auto motion = MotionTracker(TestGrid()).Find(volumes, zero);
  ASSERT_TRUE(motion);
  const Velocity with = motion->At(40.0, 40.0);
  const Velocity without = known->At(40.0, 40.0);
  EXPECT_AT_MOST(std::hypot(with.east - without.east, with.north - without.north), 0.012,
    "change of the motion by the radar outside, m/s");
}

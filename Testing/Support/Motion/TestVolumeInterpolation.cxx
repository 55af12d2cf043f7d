// SPDX-License-Identifier: BSD-3-Clause
// Formulas A1 and A2 on grids, voxel by voxel.
#include "GridMaker.h"
#include "Tolerance.h"
#include "VolumeInterpolation.h"
#include "nexrad/System/Error.h"

#include <gtest/gtest.h>

#include <cmath>

using namespace nexrad;
using nexrad::testing::MakeTestGrid;
using nexrad::testing::MakeTestVolume;
using namespace std::chrono_literals;

namespace
{

const Time noon = *ParseIso8601("2006-03-12T12:00:00Z");
constexpr VoxelState echo = VoxelState::Echo;
constexpr VoxelState none = VoxelState::NoEcho;
constexpr VoxelState folded = VoxelState::RangeFolded;
constexpr VoxelState open = VoxelState::NotScanned;

// One row of voxels of 1 km. Values where the state is not an echo are left to the volume's fill.
GriddedVolume MakeRow(
  Time time, const std::vector<VoxelState>& states, const std::vector<float>& values)
{
  GriddedVolume volume;
  volume.grid = MakeTestGrid({static_cast<int>(states.size()), 1, 1}, 1000.0);
  volume.time = time;
  volume.states = states;
  volume.values = values;
  for (std::size_t i = 0; i < states.size(); ++i)
  {
    volume.values[i] = states[i] == echo ? values[i] : volume.fill;
  }
  return volume;
}

void ExpectRow(const GriddedVolume& volume, const std::vector<VoxelState>& states,
  const std::vector<float>& values)
{
  EXPECT_EQ(volume.states, states);
  ASSERT_EQ(volume.values.size(), values.size());
  for (std::size_t i = 0; i < values.size(); ++i)
  {
    EXPECT_NEAR(volume.values[i], states[i] == echo ? values[i] : volume.fill, 1e-4) << i;
  }
}

} // namespace

TEST(LinearInterpolation, BlendsByTheSharesOfTime)
{
  const GriddedVolume before = MakeRow(noon, {echo, echo, none, echo}, {40, -10, 0, 8});
  const GriddedVolume after = MakeRow(noon + 100s, {echo, echo, echo, none}, {20, -6, 40, 0});
  // A quarter of the way: 35; −9; 10 against no echo as 0; 6 against no echo.
  ExpectRow(
    InterpolateLinear(before, after, noon + 25s), {echo, echo, echo, echo}, {35, -9, 10, 6});
}

TEST(LinearInterpolation, HasNoEchoWhereAWeakOneMeetsNone)
{
  const GriddedVolume before = MakeRow(noon, {echo, none}, {-12, 0});
  const GriddedVolume after = MakeRow(noon + 100s, {none, none}, {0, 0});
  ExpectRow(InterpolateLinear(before, after, noon + 10s), {none, none}, {0, 0});
}

TEST(LinearInterpolation, TakesTheSideThatTellsSomething)
{
  const GriddedVolume before =
    MakeRow(noon, {open, folded, open, open, folded, echo}, {0, 0, 0, 0, 0, 7});
  const GriddedVolume after =
    MakeRow(noon + 100s, {echo, echo, none, open, open, folded}, {20, 30, 0, 0, 0, 0});
  ExpectRow(InterpolateLinear(before, after, noon + 10s), {echo, echo, none, open, folded, echo},
    {20, 30, 0, 0, 0, 7});
}

TEST(LinearInterpolation, GivesTheVolumesAtTheirTimes)
{
  const GriddedVolume before = MakeRow(noon, {echo, echo, none}, {-9, 30, 0});
  const GriddedVolume after = MakeRow(noon + 100s, {none, echo, echo}, {0, 50, 12});
  ExpectRow(InterpolateLinear(before, after, noon), before.states, before.values);
  ExpectRow(InterpolateLinear(before, after, noon + 100s), after.states, after.values);
}

TEST(LinearInterpolation, KeepsWhatTheVolumesAre)
{
  GriddedVolume before = MakeRow(noon, {echo}, {30});
  GriddedVolume after = MakeRow(noon + 100s, {echo}, {30});
  before.method = after.method = "beam";
  before.sites = {"KEAX", "KLSX"};
  after.sites = {"KLSX", "KILX"};
  after.synthetic = true;
  const GriddedVolume volume = InterpolateLinear(before, after, noon + 50s);
  EXPECT_EQ(volume.sites, (std::vector<std::string>{"KEAX", "KLSX", "KILX"}));
  EXPECT_TRUE(volume.synthetic);
  EXPECT_EQ(volume.method, "beam");
  EXPECT_EQ(volume.time, noon + 50s);
}

// An echo that moves 4 km in 100 s stands 1 km along its way after 25 s, and is one echo. The row
// reaches far enough beyond it that no displaced place lies outside.
TEST(Advection, MovesAnEchoAlongItsWay)
{
  const GriddedVolume before = MakeRow(
    noon, {none, echo, none, none, none, none, none, none, none}, {0, 40, 0, 0, 0, 0, 0, 0, 0});
  const GriddedVolume after = MakeRow(noon + 100s,
    {none, none, none, none, none, echo, none, none, none}, {0, 0, 0, 0, 0, 20, 0, 0, 0});
  const MotionField motion = MotionField::Constant({40.0, 0.0});
  ExpectRow(InterpolateAlongMotion(before, after, noon + 25s, motion),
    {none, none, echo, none, none, none, none, none, none}, {0, 0, 35, 0, 0, 0, 0, 0, 0});
  // Half-way between voxels it is shared by both.
  ExpectRow(InterpolateAlongMotion(before, after, noon + 37s + 500ms, motion),
    {none, none, echo, echo, none, none, none, none, none}, {0, 0, 16.25F, 16.25F, 0, 0, 0, 0, 0});
}

TEST(Advection, WithoutMotionIsLinear)
{
  const GriddedVolume before = MakeRow(noon, {echo, none, open, folded, echo}, {40, 0, 0, 0, -3});
  const GriddedVolume after = MakeRow(noon + 100s, {none, echo, echo, open, echo}, {0, 9, 8, 0, 5});
  const GriddedVolume linear = InterpolateLinear(before, after, noon + 30s);
  ExpectRow(InterpolateAlongMotion(before, after, noon + 30s, MotionField::Constant({})),
    linear.states, linear.values);
}

TEST(Advection, GivesTheVolumesAtTheirTimes)
{
  const GriddedVolume before = MakeRow(noon, {echo, none, open, echo}, {-9, 0, 0, 30});
  const GriddedVolume after = MakeRow(noon + 100s, {none, echo, open, echo}, {0, 50, 0, 12});
  const MotionField motion = MotionField::Constant({15.0, 0.0});
  ExpectRow(InterpolateAlongMotion(before, after, noon, motion), before.states, before.values);
  ExpectRow(InterpolateAlongMotion(before, after, noon + 100s, motion), after.states, after.values);
}

// Voxel 0 has no source (outside the grid), voxel 2 none (its source was not scanned), and voxel 5
// no target: they are linear. Voxel 1 was never scanned and stays so, whatever would move there.
TEST(Advection, DoesNotBleedFromWhatWasNotScanned)
{
  const GriddedVolume before =
    MakeRow(noon, {echo, open, echo, echo, echo, echo}, {10, 0, 20, 30, 40, 50});
  const GriddedVolume after =
    MakeRow(noon + 100s, {echo, open, echo, echo, echo, echo}, {20, 0, 30, 40, 50, 60});
  const MotionField motion = MotionField::Constant({20.0, 0.0}); // a voxel each way at half time
  ExpectRow(InterpolateAlongMotion(before, after, noon + 50s, motion),
    {echo, open, echo, echo, echo, echo}, {15, 0, 25, 0.5F * (20 + 50), 0.5F * (30 + 60), 55});
}

// Three tenths of the weight of a place in what was not scanned: the rest tells. Seven: it does
// not.
TEST(Advection, NeedsHalfOfTheWeightOfAPlace)
{
  const GriddedVolume before = MakeRow(noon, {open, echo, echo, echo}, {0, 20, 30, 40});
  const GriddedVolume after = MakeRow(noon + 100s, {echo, echo, echo, echo}, {10, 10, 10, 10});
  const GriddedVolume little =
    InterpolateAlongMotion(before, after, noon + 50s, MotionField::Constant({6.0, 0.0}));
  EXPECT_NEAR(little.values[1], 0.5F * (20 + 10), 1e-4);
  EXPECT_NEAR(little.values[2], 0.5F * (0.3F * 20 + 0.7F * 30 + 10), 1e-4);
  const GriddedVolume much =
    InterpolateAlongMotion(before, after, noon + 50s, MotionField::Constant({14.0, 0.0}));
  EXPECT_NEAR(much.values[1], 0.5F * (20 + 10), 1e-4);
  EXPECT_NEAR(much.values[2], 0.5F * (0.7F * 20 + 0.3F * 30 + 10), 1e-4);
}

// A smooth field that moves is its own truth at any time; the linear way is far from it.
TEST(Advection, FollowsAFieldThatMoves)
{
  const GridSpecification grid = MakeTestGrid({60, 50, 2}, 1000.0);
  const Velocity velocity = {25.0, -15.0};
  const auto at = [&](double seconds)
  {
    return [=](double x, double y)
    {
      const double dx = x - 25e3 - seconds * velocity.east;
      const double dy = y - 28e3 - seconds * velocity.north;
      return 50.0 * std::exp(-(dx * dx + dy * dy) / 64e6);
    };
  };
  const GriddedVolume before = MakeTestVolume(grid, noon, at(0.0));
  const GriddedVolume after = MakeTestVolume(grid, noon + 300s, at(300.0));
  const GriddedVolume truth = MakeTestVolume(grid, noon + 110s, at(110.0));
  const auto moved =
    InterpolateAlongMotion(before, after, noon + 110s, MotionField::Constant(velocity));
  const auto linear = InterpolateLinear(before, after, noon + 110s);
  float worstMoved = 0.0F;
  float worstLinear = 0.0F;
  for (std::size_t i = 0; i < truth.values.size(); ++i)
  {
    const int column = static_cast<int>(i) % 60;
    const int row = static_cast<int>(i) / 60 % 50;
    if (column < 8 || column >= 52 || row < 8 || row >= 42)
    {
      continue; // from beyond the border nothing comes
    }
    worstMoved = std::max(worstMoved, std::abs(moved.values[i] - truth.values[i]));
    worstLinear = std::max(worstLinear, std::abs(linear.values[i] - truth.values[i]));
  }
  EXPECT_AT_MOST(worstMoved, 0.5F, "largest error along the motion, dBZ");
  EXPECT_AT_LEAST(worstLinear, 10.0F, "largest error of the linear interpolation, dBZ");
}

TEST(Advection, GivesTheSameHoweverTheRowsAreDivided)
{
  const GridSpecification grid = MakeTestGrid({20, 15, 2}, 1000.0);
  const GriddedVolume before =
    MakeTestVolume(grid, noon, [](double x, double y) { return 20.0 + x / 900.0 - y / 800.0; });
  const GriddedVolume after = MakeTestVolume(
    grid, noon + 100s, [](double x, double y) { return 25.0 - x / 700.0 + y / 900.0; });
  const MotionField motion = MotionField::Constant({13.0, 7.0});
  const TimeInterpolation interpolation(before, after, noon + 40s, motion);
  GriddedVolume parts = interpolation.MakeVolume();
  interpolation.FillRows(9, 15, parts);
  interpolation.FillRows(0, 4, parts);
  interpolation.FillRows(4, 9, parts);
  const GriddedVolume whole = InterpolateAlongMotion(before, after, noon + 40s, motion);
  EXPECT_EQ(parts.values, whole.values);
  EXPECT_EQ(parts.states, whole.states);
}

TEST(Advection, RefusesTimesAndMotionsThatDoNotFit)
{
  const GriddedVolume before = MakeRow(noon, {echo, echo}, {30, 30});
  const GriddedVolume after = MakeRow(noon + 100s, {echo, echo}, {30, 30});
  EXPECT_THROW(InterpolateLinear(before, after, noon - 1ms), Error);
  EXPECT_THROW(InterpolateLinear(before, after, noon + 101s), Error);
  EXPECT_THROW(InterpolateLinear(after, before, noon), Error);
  MotionField other;
  other.lattice.nodes = {3, 1};
  other.lattice.step = {4.0, 1.0};
  other.velocities.resize(3);
  EXPECT_THROW(InterpolateAlongMotion(before, after, noon + 50s, other), Error);
  other.velocities.resize(2);
  EXPECT_THROW(InterpolateAlongMotion(before, after, noon + 50s, other), Error);
}

// SPDX-License-Identifier: BSD-3-Clause
// Formulas A4, counted by hand.
#include "GridMaker.h"
#include "LeaveOneOut.h"
#include "Tolerance.h"
#include "nexrad/System/Error.h"

#include <gtest/gtest.h>

#include <cmath>

using namespace nexrad;
using nexrad::testing::MakeTestGrid;
using nexrad::testing::MakeTestVolume;
using namespace std::chrono_literals;

namespace
{

GriddedVolume MakeRow(const std::vector<VoxelState>& states, const std::vector<float>& values)
{
  GriddedVolume volume;
  volume.grid = MakeTestGrid({static_cast<int>(states.size()), 1, 1}, 1000.0);
  volume.states = states;
  volume.values = values;
  return volume;
}

} // namespace

TEST(RebuildScore, CountsByHand)
{
  constexpr VoxelState echo = VoxelState::Echo;
  constexpr VoxelState none = VoxelState::NoEcho;
  const GriddedVolume observed = MakeRow(
    {echo, echo, none, none, echo, VoxelState::RangeFolded, echo}, {36, 52, -33, -33, -5, 0, 40});
  const GriddedVolume rebuilt = MakeRow(
    {echo, echo, echo, none, none, echo, VoxelState::NotScanned}, {33, 56, 21, -33, -33, 50, 0});
  const RebuildScore score = ScoreRebuilt(rebuilt, observed);
  EXPECT_EQ(score.voxels, 5u);
  EXPECT_EQ(score.compared, 3u);
  EXPECT_NEAR(score.Rmse(), std::sqrt((9.0 + 16.0 + 441.0) / 3.0), 1e-9);
  EXPECT_DOUBLE_EQ(score.SuccessIndex(0), 2.0 / 3.0); // 36/33, 52/56; false 21
  EXPECT_DOUBLE_EQ(score.SuccessIndex(1), 0.5);       // 52/56; missed 36
  EXPECT_DOUBLE_EQ(score.SuccessIndex(2), 1.0);
}

TEST(RebuildScore, AddsUp)
{
  const GriddedVolume strong = MakeRow({VoxelState::Echo}, {52});
  const GriddedVolume weak = MakeRow({VoxelState::Echo}, {49});
  RebuildScore sum = ScoreRebuilt(strong, strong);
  sum += ScoreRebuilt(weak, strong);
  sum += ScoreRebuilt(strong, weak);
  EXPECT_EQ(sum.voxels, 3u);
  EXPECT_NEAR(sum.Rmse(), std::sqrt(18.0 / 3.0), 1e-9);
  EXPECT_DOUBLE_EQ(sum.SuccessIndex(2), 1.0 / 3.0);
  EXPECT_DOUBLE_EQ(sum.SuccessIndex(0), 1.0);
}

TEST(RebuildScore, OfNothingIsPerfect)
{
  const GriddedVolume empty = MakeRow({VoxelState::NoEcho}, {-33});
  const RebuildScore score = ScoreRebuilt(empty, empty);
  EXPECT_EQ(score.compared, 0u);
  EXPECT_EQ(score.Rmse(), 0.0);
  EXPECT_EQ(score.SuccessIndex(0), 1.0);
}

TEST(RebuildScore, RefusesVolumesOfDifferentSizes)
{
  EXPECT_THROW(ScoreRebuilt(MakeRow({VoxelState::NoEcho}, {0}), MakeRow({}, {})), Error);
}

TEST(LeaveOneOut, PrefersMotionForAStormThatMoves)
{
  const Time noon = *ParseIso8601("2006-03-12T12:00:00Z");
  const auto at = [&](double part)
  {
    const auto storm = [=](double x, double y)
    {
      const double dx = x - 80e3 - part * 12e3;
      const double dy = y - 70e3 - part * 5e3;
      return 55.0 * std::exp(-(dx * dx + dy * dy) / 81e6) - 2.0;
    };
    const auto time = noon + std::chrono::milliseconds(std::lround(part * 600'000.0));
    return MakeTestVolume(MakeTestGrid({90, 80, 1}, 2000.0), time, storm);
  };
  const LeaveOneOutScore score = LeaveOneOut(at(0.0), at(0.4), at(1.0));
  EXPECT_AT_MOST(score.alongMotion.Rmse() / score.linear.Rmse(), 0.075,
    "RMSE along the motion, part of that of the linear interpolation");
  EXPECT_AT_LEAST(score.alongMotion.SuccessIndex(1), 0.9, "success index along the motion");
  EXPECT_EQ(score.linear.SuccessIndex(1), 0.0);
}

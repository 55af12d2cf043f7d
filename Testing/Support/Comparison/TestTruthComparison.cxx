// SPDX-License-Identifier: BSD-3-Clause
#include "Comparison/TruthComparison.h"

#include "nexrad/System/Error.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

using namespace nexrad;

// Ten voxels by hand. Differences where truth or result is 10 dBZ or more, and the voxel counts:
// −3, +3, −40 (missed), +15 (false), −2 → squares 9 + 9 + 1600 + 225 + 4 = 1847 over five voxels.
TEST(TruthComparison, FollowsItsDefinition)
{
  constexpr float none = -std::numeric_limits<float>::infinity();
  constexpr VoxelState echo = VoxelState::Echo;
  constexpr VoxelState noEcho = VoxelState::NoEcho;
  constexpr VoxelState notScanned = VoxelState::NotScanned;
  GriddedVolume result;
  result.fill = -33.0F;
  result.values = {30, 13, -33, 15, 5, -33, 20, 60, 8, -33};
  result.states = {echo, echo, noEcho, echo, echo, noEcho, echo, echo, echo, notScanned};
  const std::vector<float> truth = {33, 10, 40, none, 9, none, 20, 10, 10, -5};
  const std::vector<std::uint8_t> counts = {1, 1, 1, 1, 1, 1, 0, 0, 1, 1};
  const TruthScore score = CompareWithTruth(result, truth, counts);
  EXPECT_EQ(score.voxels, 8u);
  EXPECT_EQ(score.compared, 5u);
  EXPECT_EQ(score.trueEcho, 4u);
  EXPECT_EQ(score.missed, 1u);
  EXPECT_EQ(score.falseEcho, 1u);
  EXPECT_DOUBLE_EQ(score.MissedFraction(), 0.25);
  EXPECT_DOUBLE_EQ(score.FalseFraction(), 0.25);
  EXPECT_NEAR(score.rmse, std::sqrt(1847.0 / 5.0), 1e-9);
  EXPECT_NEAR(score.bias, -27.0 / 5.0, 1e-9);
}

TEST(TruthComparison, NothingToCompareIsNoError)
{
  GriddedVolume result;
  result.values = {0.0F};
  result.states = {VoxelState::NoEcho};
  const TruthScore score = CompareWithTruth(result, {0.0F}, {1});
  EXPECT_EQ(score.rmse, 0.0);
  EXPECT_EQ(score.MissedFraction(), 0.0);
  EXPECT_THROW(CompareWithTruth(result, {}, {1}), Error);
  EXPECT_THROW(CompareWithTruth(result, {0.0F}, {}), Error);
}

// SPDX-License-Identifier: BSD-3-Clause
#include "GridMaker.h"
#include "Motion/VolumeMotion.h"

#include <gtest/gtest.h>

using namespace nexrad;
using nexrad::testing::MakeTestGrid;

namespace
{

MotionImage MakeImage(int columns, int rows, const std::vector<float>& values)
{
  MotionImage image;
  image.columns = columns;
  image.rows = rows;
  image.values = values;
  image.scanned.assign(values.size(), 1);
  return image;
}

} // namespace

TEST(MotionImage, HoldsTheStrongestEchoOfEachColumn)
{
  GriddedVolume volume;
  volume.grid = MakeTestGrid({3, 1, 2}, 1000.0);
  volume.values = {12.0F, -33.0F, -33.0F, 30.0F, -5.0F, -33.0F};
  volume.states = {VoxelState::Echo, VoxelState::NoEcho, VoxelState::NotScanned, VoxelState::Echo,
    VoxelState::Echo, VoxelState::NotScanned};
  const MotionImage image = ColumnMaximum(volume);
  EXPECT_EQ(image.values, (std::vector<float>{30.0F, 0.0F, 0.0F}));
  EXPECT_EQ(image.scanned, (std::vector<std::uint8_t>{1, 1, 0}));
}

TEST(MotionImage, HalvesByTheMeanOfWhatWasScanned)
{
  MotionImage image = MakeImage(3, 2, {10, 20, 40, 30, 60, 50});
  image.scanned[4] = 0;
  const MotionImage half = Halve(image);
  ASSERT_EQ(half.columns, 2);
  ASSERT_EQ(half.rows, 1);
  EXPECT_FLOAT_EQ(half.values[0], 20.0F); // 10, 20 and 30
  EXPECT_FLOAT_EQ(half.values[1], 45.0F); // 40 and 50; the image ends there
  EXPECT_DOUBLE_EQ(half.ToVoxel(0, 0), 0.5);
  EXPECT_DOUBLE_EQ(half.ToVoxel(1, 1), 2.5);
}

TEST(MotionImage, SmoothsInTheRatioOneTwoOne)
{
  MotionImage image = MakeImage(3, 3, {0, 0, 0, 0, 16, 0, 0, 0, 0});
  const MotionImage smooth = Smooth(image);
  EXPECT_FLOAT_EQ(smooth.values[4], 4.0F);         // 16 · 4/16
  EXPECT_FLOAT_EQ(smooth.values[0], 16.0F / 9.0F); // 16 · 1/(4 + 2 + 2 + 1)
  image.scanned[1] = 0;
  EXPECT_EQ(Smooth(image).scanned[1], 0);
}

TEST(MotionImage, SamplesValueAndSlopeBetweenPixels)
{
  const MotionImage image = MakeImage(2, 2, {10, 14, 20, 28});
  const auto sample = SampleImage(image, 0.5, 0.25);
  ASSERT_TRUE(sample);
  EXPECT_DOUBLE_EQ(sample->value, 0.75 * 12.0 + 0.25 * 24.0);
  EXPECT_DOUBLE_EQ(sample->perColumn, 0.75 * 4.0 + 0.25 * 8.0);
  EXPECT_DOUBLE_EQ(sample->perRow, 12.0);
  EXPECT_TRUE(SampleImage(image, 1.0, 1.0));
}

TEST(MotionImage, HasNoSampleOutsideOrBesideWhatWasNotScanned)
{
  MotionImage image = MakeImage(3, 2, {1, 2, 3, 4, 5, 6});
  EXPECT_FALSE(SampleImage(image, -0.01, 0.0));
  EXPECT_FALSE(SampleImage(image, 2.01, 0.0));
  EXPECT_FALSE(SampleImage(image, 0.0, 1.01));
  image.scanned[5] = 0;
  EXPECT_FALSE(SampleImage(image, 1.5, 0.5));
  EXPECT_TRUE(SampleImage(image, 0.5, 0.5));
}

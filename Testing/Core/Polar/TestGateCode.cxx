// SPDX-License-Identifier: BSD-3-Clause
#include "nexrad/Polar/GateCode.h"

#include <gtest/gtest.h>

#include <cmath>

using namespace nexrad;

TEST(GateScale, KeepsTheStepsOfFilesExactly)
{
  // The words of reflectivity, of velocity by 1 m/s and of differential reflectivity.
  struct Words
  {
    float least, step;
    int count;
  };
  for (const Words& words : {Words{-32.0F, 0.5F, 254}, Words{-127.0F, 1.0F, 254},
         Words{-7.875F, 0.0625F, 254}, Words{-13.0F, 0.03125F, 1000}})
  {
    const float most = words.least + words.step * static_cast<float>(words.count - 1);
    const GateScale scale = GateScale::Between(words.least, most);
    for (int word = 0; word < words.count; ++word)
    {
      const float value = words.least + words.step * static_cast<float>(word);
      ASSERT_EQ(scale.ValueOf(scale.CodeOf(value)), value);
    }
  }
}

TEST(GateScale, RoundsOtherNumbersToLittle)
{
  for (const float least : {-1e4F, -64.0F, -0.001F, 0.2F, 47.3F, 3e4F})
  {
    for (const float range : {1e-3F, 1.05F, 64.0F, 65.0F, 360.0F, 1e5F})
    {
      const float most = least + range;
      const GateScale scale = GateScale::Between(least, most);
      ASSERT_GT(scale.step, 0.0F);
      EXPECT_GE(scale.CodeOf(least), GateCode::FirstValue);
      EXPECT_GT(scale.CodeOf(most), scale.CodeOf(least));
      const float ulp = std::nextafter(std::max(std::abs(least), std::abs(most)), 1e9F) -
                        std::max(std::abs(least), std::abs(most));
      EXPECT_LE(scale.step, std::max(range / 32'000.0F, 4.0F * ulp)) << least << " " << range;
      for (const float part : {0.0F, 0.123F, 0.5F, 0.77F, 1.0F})
      {
        const float value = std::min(least + part * range, most);
        EXPECT_NEAR(scale.ValueOf(scale.CodeOf(value)), value, 0.51F * scale.step);
      }
    }
  }
}

TEST(GateScale, HasRoomForOneNumberAlone)
{
  for (const float value : {-33.5F, 0.0F, 1e-20F, 47.3F})
  {
    const GateScale scale = GateScale::Between(value, value);
    EXPECT_FLOAT_EQ(scale.ValueOf(scale.CodeOf(value)), value);
  }
}

TEST(GateScale, NumbersOutsideTakeTheNearestCode)
{
  const GateScale scale = GateScale::Between(0.0F, 60.0F);
  EXPECT_EQ(scale.CodeOf(-1e9F), GateCode::FirstValue);
  EXPECT_EQ(scale.CodeOf(1e9F), GateCode::Last);
  EXPECT_EQ(GateScale().CodeOf(5.0F), GateCode::FirstValue);
}

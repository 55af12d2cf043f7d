// SPDX-License-Identifier: BSD-3-Clause
#include "nexrad/Thesis/ThesisMerge.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

using namespace nexrad;

namespace
{

constexpr float unknown = std::numeric_limits<float>::quiet_NaN();

// Fills one column and gives it back; −1 stands for what stayed unknown.
std::vector<float> Filled(std::vector<float> column)
{
  FillColumns(column, {1, 1, static_cast<int>(column.size())});
  for (float& value : column)
  {
    value = std::isnan(value) ? -1.0F : value;
  }
  return column;
}

} // namespace

TEST(ColumnFillingT7, LinearBetweenCopiedBelowNothingAbove)
{
  EXPECT_EQ(Filled({unknown, unknown, 10.0F, unknown, unknown, unknown, 30.0F, unknown}),
    (std::vector<float>{10.0F, 10.0F, 10.0F, 15.0F, 20.0F, 25.0F, 30.0F, -1.0F}));
}

TEST(ColumnFillingT7, SeveralGaps)
{
  EXPECT_EQ(Filled({0.0F, unknown, 40.0F, 20.0F, unknown, 0.0F, unknown}),
    (std::vector<float>{0.0F, 20.0F, 40.0F, 20.0F, 10.0F, 0.0F, -1.0F}));
}

TEST(ColumnFillingT7, KnownValuesStayAndEmptyColumnsStayEmpty)
{
  EXPECT_EQ(Filled({1.0F, 2.0F, 3.0F}), (std::vector<float>{1.0F, 2.0F, 3.0F}));
  EXPECT_EQ(Filled({unknown, unknown}), (std::vector<float>{-1.0F, -1.0F}));
  EXPECT_EQ(Filled({unknown, unknown, 7.0F}), (std::vector<float>{7.0F, 7.0F, 7.0F}));
  EXPECT_EQ(Filled({7.0F, unknown, unknown}), (std::vector<float>{7.0F, -1.0F, -1.0F}));
}

// Two columns of three levels, x fastest.
TEST(ColumnFillingT7, EachColumnIsFilledOfItsOwnVoxels)
{
  std::vector<float> values = {unknown, unknown, 4.0F, 8.0F, unknown, unknown};
  FillColumns(values, {2, 1, 3});
  EXPECT_EQ(values[0], 4.0F);
  EXPECT_EQ(values[1], 8.0F);
  EXPECT_TRUE(std::isnan(values[4]));
}

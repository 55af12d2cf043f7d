// SPDX-License-Identifier: BSD-3-Clause
#include "nexrad/System/Progress.h"

#include <gtest/gtest.h>

using namespace nexrad;

TEST(Progress, AShareFillsItsPartOfTheWhole)
{
  double told = -1.0;
  const Progress whole = [&told](double done)
  {
    told = done;
    return done < 0.7;
  };
  const Progress share = ShareOf(whole, 0.4, 0.8);
  EXPECT_TRUE(share(0.0));
  EXPECT_DOUBLE_EQ(told, 0.4);
  EXPECT_TRUE(share(0.5));
  EXPECT_DOUBLE_EQ(told, 0.6);
  EXPECT_FALSE(share(1.0)) << "who listens to the whole stops the part";
  EXPECT_DOUBLE_EQ(told, 0.8);
}

TEST(Progress, EqualPartsFollowEachOther)
{
  double told = -1.0;
  const Progress whole = [&told](double done)
  {
    told = done;
    return true;
  };
  ShareOf(whole, std::size_t(0), std::size_t(4))(1.0);
  EXPECT_DOUBLE_EQ(told, 0.25);
  ShareOf(ShareOf(whole, std::size_t(3), std::size_t(4)), 0.0, 0.5)(1.0);
  EXPECT_DOUBLE_EQ(told, 0.875);
}

TEST(Progress, APartOfWhatNobodyHearsIsHeardByNobody)
{
  EXPECT_FALSE(ShareOf(Progress(), 0.0, 0.5));
}

// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "nexrad/Grid/GriddedVolume.h"

#include <gtest/gtest.h>

namespace nexrad::testing
{

/// Expects that two volumes of one moment hold the same; further moments are not compared.
inline void ExpectSameVolume(const GriddedVolume& actual, const GriddedVolume& expected)
{
  EXPECT_TRUE(actual.grid == expected.grid);
  EXPECT_EQ(actual.time, expected.time);
  EXPECT_EQ(actual.moment, expected.moment);
  EXPECT_EQ(actual.method, expected.method);
  EXPECT_EQ(actual.sites, expected.sites);
  EXPECT_TRUE(actual.sitePositions == expected.sitePositions);
  EXPECT_EQ(actual.synthetic, expected.synthetic);
  EXPECT_EQ(actual.fill, expected.fill);
  EXPECT_EQ(actual.values, expected.values);
  EXPECT_EQ(actual.states, expected.states);
  EXPECT_EQ(actual.ancillary.age, expected.ancillary.age);
  EXPECT_EQ(actual.ancillary.radars, expected.ancillary.radars);
  EXPECT_EQ(actual.ancillary.weight, expected.ancillary.weight);
  EXPECT_EQ(actual.ancillary.nearestSite, expected.ancillary.nearestSite);
}

} // namespace nexrad::testing

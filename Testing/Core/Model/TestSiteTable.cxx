// SPDX-License-Identifier: BSD-3-Clause
#include "nexrad/Model/SiteTable.h"

#include <gtest/gtest.h>

using namespace nexrad;

TEST(SiteTable, KnowsTheSitesOfTheThesis)
{
  const KnownSite* site = FindSite("KLSX");
  ASSERT_NE(site, nullptr);
  EXPECT_NEAR(site->position.latitude, 38.70, 0.01);
  EXPECT_NEAR(site->position.longitude, -90.68, 0.01);
  EXPECT_EQ(site->state, "MO");
  EXPECT_FALSE(site->terminal);
  EXPECT_NE(FindSite("KEAX"), nullptr);
  EXPECT_NE(FindSite("KILX"), nullptr);
}

TEST(SiteTable, UnknownNamesAreNotFound)
{
  EXPECT_EQ(FindSite(""), nullptr);
  EXPECT_EQ(FindSite("klsx"), nullptr);
  EXPECT_EQ(FindSite("ZZZZ"), nullptr);
}

TEST(SiteTable, EveryPositionIsOnEarth)
{
  EXPECT_EQ(KnownSites().size(), 209U);
  for (const KnownSite& site : KnownSites())
  {
    EXPECT_EQ(site.name.size(), 4U);
    EXPECT_LE(std::abs(site.position.latitude), 90.0) << site.name;
    EXPECT_LE(std::abs(site.position.longitude), 180.0) << site.name;
    EXPECT_GT(site.position.altitude, -50.0) << site.name;
    EXPECT_LT(site.position.altitude, 3500.0) << site.name;
  }
}

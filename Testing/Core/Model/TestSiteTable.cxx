// SPDX-License-Identifier: BSD-3-Clause
#include "nexrad/Model/SiteTable.h"

#include "ErrorMessage.h"

#include <gtest/gtest.h>

#include <cmath>
#include <string>

using namespace nexrad;
using nexrad::testing::MessageOf;

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

TEST(SiteTable, RowsAreReadAndOrdered)
{
  const std::vector<KnownSite> sites = ParseSiteTable("heading\nTBBB,tdwr,B,KS,-37.5,97.25,,28.5\n"
                                                      "KAAA,wsr88d,A,MO,38.5,-90.25,185,220\n");
  ASSERT_EQ(sites.size(), 2U);
  EXPECT_EQ(sites[0].name, "KAAA");
  EXPECT_EQ(sites[0].position, (Position{38.5, -90.25, 220.0}));
  EXPECT_TRUE(sites[1].terminal);
  EXPECT_EQ(sites[1].position.altitude, 28.5);
}

// A number that was none ended the program, and one with a comma lost what followed.
TEST(SiteTable, AWrongRowIsNamed)
{
  for (const char* row : {"KAAA", "KAAA,wsr88d,A,MO,,-90.25,185,220",
         ",wsr88d,A,MO,38.5,-90.25,185,220", "KAAA,wsr88d,A,MO,north,-90.25,185,220",
         "KAAA,wsr88d,A,MO,38.5x,-90.25,185,220", "KAAA,wsr88d,A,MO,90.5,-90.25,185,220",
         "KAAA,wsr88d,A,MO,38.5,nan,185,220", "KAAA,wsr88d,A,MO,38.5,-90.25,185,1e999", ""})
  {
    const std::string error =
      MessageOf([&] { ParseSiteTable(std::string("heading\n") + row + "\n"); });
    EXPECT_EQ(error.rfind("line 2 of the site table: ", 0), 0U) << error;
  }
}

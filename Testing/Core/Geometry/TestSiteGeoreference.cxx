// SPDX-License-Identifier: BSD-3-Clause
#include "nexrad/Geometry/SiteGeoreference.h"

#include <gtest/gtest.h>

using namespace nexrad;

// Vincenty's geodesic from Flinders Peak to Buninyong (Geocentric Datum of Australia technical
// manual, GRS80, which differs from WGS84 by less than 0.1 mm here): 54 972.271 m at 306°52'05.37".
TEST(SiteGeoreferenceB3, AgreesWithAPublishedGeodesic)
{
  const Position flindersPeak = {
    -(37 + 57 / 60.0 + 3.72030 / 3600.0), 144 + 25 / 60.0 + 29.52440 / 3600.0, 0.0};
  const double latitude = -(37 + 39 / 60.0 + 10.15610 / 3600.0);
  const double longitude = 143 + 55 / 60.0 + 35.38390 / 3600.0;
  const GroundDirection direction = SiteGeoreference(flindersPeak).Look(longitude, latitude);
  EXPECT_NEAR(direction.groundDistance, 54'972.271, 0.002);
  EXPECT_NEAR(direction.azimuth, 306 + 52 / 60.0 + 5.37 / 3600.0, 0.01 / 3600.0);
}

TEST(SiteGeoreferenceB3, LocateAndLookAreInverse)
{
  const SiteGeoreference site({38.81025, -94.26447, 330.0});
  for (const double azimuth : {0.0, 0.5, 89.5, 180.0, 271.25, 359.5})
  {
    const auto place = site.Locate({azimuth, 230'000.0});
    const GroundDirection back = site.Look(place[0], place[1]);
    EXPECT_NEAR(back.azimuth, azimuth, 1e-9);
    EXPECT_NEAR(back.groundDistance, 230'000.0, 1e-6);
  }
}

TEST(SiteGeoreferenceB3, AzimuthTurnsFromNorthOverEast)
{
  const SiteGeoreference site({40.0, -90.0, 0.0});
  EXPECT_GT(site.Locate({0.0, 1000.0})[1], 40.0);
  EXPECT_GT(site.Locate({90.0, 1000.0})[0], -90.0);
  EXPECT_LT(site.Locate({180.0, 1000.0})[1], 40.0);
  EXPECT_LT(site.Locate({270.0, 1000.0})[0], -90.0);
}

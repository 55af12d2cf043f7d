// SPDX-License-Identifier: BSD-3-Clause
#include "nexrad/Settings/ValueTexts.h"

#include "ErrorMessage.h"
#include "nexrad/Grid/MakeGrid.h"
#include "nexrad/System/Error.h"

#include <gtest/gtest.h>

using namespace nexrad;
using nexrad::testing::MessageOf;

TEST(ValueTexts, DurationsHaveUnits)
{
  using namespace std::chrono_literals;
  EXPECT_EQ(ParseDuration("5min"), 5min);
  EXPECT_EQ(ParseDuration("90"), 90s);
  EXPECT_EQ(ParseDuration("90s"), 90s);
  EXPECT_EQ(ParseDuration("1.5h"), 90min);
  EXPECT_EQ(ParseDuration("1d"), 24h);
  EXPECT_EQ(ParseDuration("0"), 0s);
  EXPECT_EQ(ParseDuration("0.0004"), 0ms);
  EXPECT_EQ(ParseDuration("0.0006"), 1ms);
}

TEST(ValueTexts, DurationsThatAreNone)
{
  for (const char* text : {"", "min", "5 min", "5minutes", "-5min", "5m", "1e3", "1.2.3s", "nan",
         "inf", "99999999999d", "0x5"})
  {
    EXPECT_THROW(ParseDuration(text), Error) << text;
  }
}

TEST(ValueTexts, LengthsAreMetres)
{
  EXPECT_EQ(ParseLength("230km"), 230'000.0);
  EXPECT_EQ(ParseLength("500m"), 500.0);
  EXPECT_EQ(ParseLength("0.5km"), 500.0);
  EXPECT_EQ(ParseLength("-12m"), -12.0);
  EXPECT_EQ(ParseLength("0"), 0.0);
  for (const char* text : {"", "km", "230 km", "230nmi", "1e5", "--5km", "230", "-12", "0.5"})
  {
    EXPECT_THROW(ParseLength(text), Error) << text;
  }
}

// 230 could be kilometres to one and metres to another.
TEST(ValueTexts, ALengthWithoutAUnitSaysWhatToWrite)
{
  const auto message = [](auto parse, const char* text) { return MessageOf([&] { parse(text); }); };
  EXPECT_EQ(message(ParseLength, "230"), "'230' has no unit; write 230km or 230m");
  EXPECT_EQ(message(ParseHeightRange, "0,20"), "'0,20' has no unit; write 0,20km or 0,20m");
}

TEST(ValueTexts, MemoryIsBytes)
{
  EXPECT_EQ(ParseMemory("512MiB"), 536'870'912U);
  EXPECT_EQ(ParseMemory("1.5GiB"), 1'610'612'736U);
  EXPECT_EQ(ParseMemory("2KiB"), 2048U);
  EXPECT_EQ(ParseMemory("0"), 0U);
  for (const std::string text : {"", "1GB", "-1MiB", "much", "2000GiB", "1e30"})
  {
    EXPECT_THROW(ParseMemory(text), Error) << text;
  }
}

TEST(ValueTexts, OneUnitCountsForBothHeights)
{
  EXPECT_EQ(ParseHeightRange("0,20km"), std::make_pair(0.0, 20'000.0));
  EXPECT_EQ(ParseHeightRange("1,20km"), std::make_pair(1'000.0, 20'000.0));
  EXPECT_EQ(ParseHeightRange("500m,20km"), std::make_pair(500.0, 20'000.0));
  EXPECT_EQ(ParseHeightRange("-100,15000m"), std::make_pair(-100.0, 15'000.0));
  for (const char* text :
    {"20km,0", "5km,5km", "5km", "0,10km,20km", ",20km", "0,", "0,high", "0,20", "1km,20"})
  {
    EXPECT_THROW(ParseHeightRange(text), Error) << text;
  }
}

TEST(ValueTexts, Dimensions)
{
  EXPECT_EQ(ParseDimensions("256x128x1"), (std::array<int, 3>{256, 128, 1}));
  EXPECT_EQ(ParseDimensions("256,128,1"), (std::array<int, 3>{256, 128, 1}));
  for (const char* text : {"", "256", "256x256", "256x256x128x1", "0x256x128", "-1x2x3", "2x2x2.5",
         "256 x 256 x 128", "99999999999999999999x1x1", "axbxc", "2x2x"})
  {
    EXPECT_THROW(ParseDimensions(text), Error) << text;
  }
}

TEST(ValueTexts, PictureSizes)
{
  EXPECT_EQ(ParsePictureSize("1280x720"), (std::array<int, 2>{1280, 720}));
  for (const char* text : {"1280", "15x720", "1280x16385", "1280x720x3"})
  {
    EXPECT_THROW(ParsePictureSize(text), Error) << text;
  }
}

TEST(ValueTexts, MotionIsEastAndNorth)
{
  EXPECT_EQ(ParseMotion("12,-7.5").east, 12.0);
  EXPECT_EQ(ParseMotion("12,-7.5").north, -7.5);
  EXPECT_EQ(ParseMotion("-90,120").north, 120.0); // 150 m/s
  for (const char* text : {"", "12", "12,", ",12", "1,2,3", "12 7", "12m/s,7m/s", "91,120"})
  {
    EXPECT_THROW(ParseMotion(text), Error) << text;
  }
}

TEST(ValueTexts, BoundsAreWestSouthEastNorth)
{
  const GeographicBounds bounds = ParseBounds("-97.5,36,-86,43");
  EXPECT_EQ(bounds.west, -97.5);
  EXPECT_EQ(bounds.south, 36.0);
  EXPECT_EQ(bounds.east, -86.0);
  EXPECT_EQ(bounds.north, 43.0);
  for (const char* text : {"", "-97,36,-86", "-86,36,-97,43", "-97,43,-86,36", "-97,36,-97,43",
         "-97,36,-86,91", "-97,36,-86,43,0", "west,south,east,north", "-97,36,,43"})
  {
    EXPECT_THROW(ParseBounds(text), Error) << text;
  }
}

TEST(ValueTexts, PlacesOfOneThingShareAUnit)
{
  PlaceUnit metres = PlaceUnit::OfVolume;
  EXPECT_EQ(ParsePlace("0", metres), 0.0);
  EXPECT_EQ(metres, PlaceUnit::OfVolume) << "0 has no unit";
  EXPECT_EQ(ParsePlace("-20km", metres), -20'000.0);
  EXPECT_EQ(metres, PlaceUnit::Metres);
  EXPECT_EQ(ParsePlace("500m", metres), 500.0);
  EXPECT_EQ(ParsePlace("0", metres), 0.0);
  EXPECT_THROW(ParsePlace("1deg", metres), Error);
  PlaceUnit degrees = PlaceUnit::OfVolume;
  EXPECT_EQ(ParsePlace("-97.5deg", degrees), -97.5);
  EXPECT_EQ(degrees, PlaceUnit::Degrees);
  EXPECT_THROW(ParsePlace("20km", degrees), Error);
  for (const char* text : {"", "deg", "361deg", "1e1deg", "20", "20 km", "20nmi", "nandeg"})
  {
    PlaceUnit unit = PlaceUnit::OfVolume;
    EXPECT_THROW(ParsePlace(text, unit), Error) << text;
    EXPECT_EQ(unit, PlaceUnit::OfVolume) << text;
  }
}

TEST(ValueTexts, BoxesHaveFacesAboveTheOppositeOnes)
{
  PlaceUnit unit = PlaceUnit::OfVolume;
  EXPECT_EQ(
    ParseBox("-98deg,-97deg,0,36.5deg", unit), (std::array<double, 4>{-98.0, -97.0, 0.0, 36.5}));
  EXPECT_EQ(unit, PlaceUnit::Degrees);
  unit = PlaceUnit::OfVolume;
  EXPECT_EQ(ParseBoxWithHeights("-50km,500m,0,60km,0,15km", unit),
    (std::array<double, 6>{-50e3, 500.0, 0.0, 60e3, 0.0, 15e3}));
  EXPECT_EQ(unit, PlaceUnit::Metres);
  for (const char* text : {"", "1km,2km,3km", "1km,2km,3km,4km,5km", "2km,1km,3km,4km",
         "1km,2km,3km,3km", "1km,2km,3km,", "1,2,3,4", "-98deg,-97deg,1km,2km"})
  {
    PlaceUnit any = PlaceUnit::OfVolume;
    EXPECT_THROW(ParseBox(text, any), Error) << text;
  }
  unit = PlaceUnit::OfVolume;
  EXPECT_THROW(ParseBoxWithHeights("-98deg,-97deg,35deg,36deg,0,1deg", unit), Error);
}

TEST(ValueTexts, ListsHaveCommas)
{
  EXPECT_EQ(SplitAtCommas(""), std::vector<std::string>{""});
  EXPECT_EQ(SplitAtCommas("a,,b"), (std::vector<std::string>{"a", "", "b"}));
  EXPECT_EQ(SplitAtCommas("a,"), (std::vector<std::string>{"a", ""}));
  EXPECT_EQ(FindNumbers("1,-2.5"), (std::vector<double>{1.0, -2.5}));
  for (const char* text : {"", "1,", "1km", "1,x", "1e3", "nan", "1 2"})
  {
    EXPECT_TRUE(FindNumbers(text).empty()) << text;
  }
}

TEST(ValueTexts, ErrorsSayWhatWouldBeRight)
{
  const std::string error = MessageOf([&] { ParseBounds("-86,36,-97,43"); });
  EXPECT_EQ(error,
    "'-86,36,-97,43' has its lower bound above its upper bound; write west,south,east,north in "
    "degrees with west below east and south below north");
}

// SPDX-License-Identifier: BSD-3-Clause
#include "nexrad/Model/Time.h"

#include <gtest/gtest.h>

using namespace nexrad;

TEST(Time, Level2DayOneIsTheEpoch)
{
  EXPECT_EQ(FormatIso8601(FromLevel2Date(1, 0)), "1970-01-01T00:00:00.000Z");
  EXPECT_EQ(FormatIso8601(FromLevel2Date(13017, 9'799'671)), "2005-08-21T02:43:19.671Z");
}

TEST(Time, FormatsAndParsesTheSameInstant)
{
  for (const char* text : {"1991-06-05T16:21:26.000Z", "2000-02-29T23:59:59.999Z",
         "1969-12-31T23:59:59.001Z", "2100-03-01T00:00:00.000Z"})
  {
    const auto time = ParseIso8601(text);
    ASSERT_TRUE(time) << text;
    EXPECT_EQ(FormatIso8601(*time), text);
    EXPECT_EQ(FromSeconds(ToSeconds(*time)), *time);
  }
}

TEST(Time, ParsesShorterForms)
{
  const Time noon = *ParseIso8601("2006-03-12T12:00:00.000Z");
  EXPECT_EQ(ParseIso8601("2006-03-12T12:00"), noon);
  EXPECT_EQ(ParseIso8601("2006-03-12 12:00:00Z"), noon);
  EXPECT_EQ(ParseIso8601("2006-03-12"), noon - std::chrono::hours(12));
}

TEST(Time, RefusesWhatIsNoTime)
{
  for (const char* text : {"", "yesterday", "2006-02-29", "2006-13-01", "2006-03-12T24:00",
         "2006-03-12T12:60", "2006-03-12T12:00:61", "2006-03-12x12:00", "2006-03-12T12:00 now"})
  {
    EXPECT_FALSE(ParseIso8601(text)) << text;
  }
}

TEST(Time, FileNameHasNoPunctuation)
{
  EXPECT_EQ(FormatForFileName(*ParseIso8601("2006-03-12T18:05:00.250Z")), "20060312T180500Z");
}

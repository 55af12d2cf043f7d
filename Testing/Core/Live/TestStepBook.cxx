// SPDX-License-Identifier: BSD-3-Clause
#include "nexrad/Live/StepBook.h"

#include "nexrad/System/Error.h"

#include "Scans/RadarsOfMissouri.h"

#include <gtest/gtest.h>

using namespace nexrad;
using nexrad::testing::noon;
using namespace std::chrono_literals;

namespace
{

} // namespace

TEST(StepBooks, HaveTheStepsBetweenFirstAndNewestRay)
{
  StepBook book({5min, {}, {}, 15min});
  EXPECT_TRUE(book.Open().empty());
  book.Extend(noon + 1min, noon + 4min);
  EXPECT_TRUE(book.Open().empty());
  book.Extend(noon + 1min, noon + 10min);
  EXPECT_EQ(book.Open(), (std::vector<Time>{noon + 5min, noon + 10min}));
  book.Extend(noon - 1min, noon + 10min);
  EXPECT_EQ(book.Open().front(), noon);
}

TEST(StepBooks, BeginAndEndWhereTheRulesSay)
{
  StepBook book({5min, noon + 10min, noon + 20min, 1h});
  book.Extend(noon, noon + 40min);
  EXPECT_EQ(book.Open(), (std::vector<Time>{noon + 10min, noon + 15min, noon + 20min}));
}

TEST(StepBooks, AStepIsMadeAtOnceAndAgainWhenItsInputsHaveSettled)
{
  StepBook book({5min, {}, {}, 15min});
  book.Extend(noon, noon + 1min);
  EXPECT_TRUE(book.IsDue(noon, "some sweeps", false));
  book.Make(noon, "some sweeps");
  EXPECT_FALSE(book.IsDue(noon, "more sweeps", false));
  EXPECT_TRUE(book.IsDue(noon, "all sweeps", true));
  book.Make(noon, "all sweeps");
  EXPECT_FALSE(book.IsDue(noon, "all sweeps", true));
}

TEST(StepBooks, AStepHasALastChanceBeforeItCloses)
{
  StepBook book({5min, {}, {}, 15min});
  book.Extend(noon, noon + 1min);
  book.Make(noon, "some sweeps");
  book.Extend(noon, noon + 16min);
  EXPECT_TRUE(book.IsClosing(noon));
  EXPECT_FALSE(book.IsClosing(noon + 5min));
  EXPECT_TRUE(book.IsDue(noon, "more sweeps", false));
  book.Make(noon, "more sweeps");
  book.Close();
  EXPECT_EQ(book.Open().front(), noon + 5min);
  EXPECT_EQ(book.Made(), std::vector<Time>{noon});
}

// Nobody wants a volume for each five minutes of the days in which nothing arrived.
TEST(StepBooks, HaveNoStepsInAPauseOfDays)
{
  StepBook book({5min, {}, {}, 15min});
  book.Extend(noon, noon + 1min);
  book.Make(noon, "some sweeps");
  book.Extend(noon, noon + 100h);
  ASSERT_FALSE(book.Open().empty());
  EXPECT_GE(book.Open().front(), noon + 100h - 20min);
}

TEST(StepBooks, GoOnWhereTheyWere)
{
  StepBook book({5min, {}, {}, 15min});
  book.Extend(noon, noon + 21min);
  for (const Time step : book.Open())
  {
    book.Make(step, "of " + FormatIso8601(step));
  }
  book.Close();
  StepBook next({5min, {}, {}, 15min});
  next.Unpack(book.Pack());
  EXPECT_TRUE(next.Open().empty()) << "nothing arrived in this run";
  next.Extend(noon + 2min, noon + 21min);
  EXPECT_EQ(next.Open(), book.Open());
  EXPECT_EQ(next.Made(), book.Made());
  EXPECT_FALSE(next.IsDue(noon + 10min, "of " + FormatIso8601(noon + 10min), true));
  EXPECT_THROW(next.Unpack("{}"), Error);
  EXPECT_THROW(next.Unpack("["), Error);
  EXPECT_EQ(next.Made(), book.Made());
}

TEST(StepBooks, AreMadeAnewForAnotherDomain)
{
  StepBook book({5min, {}, {}, 15min});
  book.Extend(noon, noon + 1min);
  book.Make(noon, "one radar");
  book.Restart();
  EXPECT_TRUE(book.IsDue(noon, "one radar", false));
  EXPECT_TRUE(book.Made().empty());
}

TEST(StepBooks, DroppedStepsAreNotMadeAgain)
{
  StepBook book({5min, {}, {}, 15min});
  book.Extend(noon, noon + 21min);
  for (const Time step : book.Open())
  {
    book.Make(step, "");
  }
  book.Drop(noon + 15min);
  EXPECT_EQ(book.Made(), (std::vector<Time>{noon + 15min, noon + 20min}));
  EXPECT_EQ(book.Open().front(), noon + 15min);
}

// The step without a time was read from where no time is; the others overflowed in sums.
TEST(StepBooks, RefuseTimesThatAreNone)
{
  StepBook book({5min, {}, {}, 15min});
  const auto with = [&book](
                      const std::string& first, const std::string& closed, const std::string& step)
  {
    book.Unpack("{\"first\":" + first + ",\"closed_until\":" + closed + ",\"steps\":[[" + step +
                ",\"inputs\",true]]}");
  };
  const std::string usual = std::to_string(noon.time_since_epoch().count());
  EXPECT_NO_THROW(with("null", "null", usual));
  EXPECT_NO_THROW(with(usual, usual, usual));
  EXPECT_THROW(with("null", "null", "null"), Error);
  for (const char* time : {"9223372036854775807", "-9223372036854775808", "253402300800000",
         "18446744073709551615", "1e300", "\"noon\""})
  {
    EXPECT_THROW(with(time, "null", usual), Error) << time;
    EXPECT_THROW(with("null", time, usual), Error) << time;
    EXPECT_THROW(with("null", "null", time), Error) << time;
  }
}

// More than a million steps, or a hundred thousand of a year: nobody waits for them.
TEST(StepBooks, HaveNoStepsSinceAVolumeOfAnotherDecade)
{
  StepBook book({5min, {}, {}, 15min});
  book.Extend(noon - 90'000h, noon - 90'000h + 4min);
  book.Extend(noon, noon + 4min);
  EXPECT_GE(book.Open().front(), noon - 20min);
  EXPECT_EQ(book.Open().back(), noon);

  StepBook late({5min, {}, {}, 15min});
  late.Extend(noon, noon + 4min);
  late.Extend(noon - 9'000h, noon - 9'000h + 4min);
  EXPECT_EQ(late.Open(), std::vector<Time>{noon});

  StepBook wide({5min, {}, {}, 15min});
  wide.Extend(noon - 90'000h, noon + 4min);
  EXPECT_GE(wide.Open().front(), noon - 24h) << "no volume is longer";
}

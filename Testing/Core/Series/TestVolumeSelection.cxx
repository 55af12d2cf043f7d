// SPDX-License-Identifier: BSD-3-Clause
#include "nexrad/Series/VolumeSelection.h"

#include "Scans/RadarsOfMissouri.h"
#include "nexrad/System/Error.h"

#include <gtest/gtest.h>

using namespace nexrad;
using nexrad::testing::At;
using namespace std::chrono_literals;

namespace
{

using Indices = std::vector<std::size_t>;

const std::vector<Time> starts = {
  At("2006-03-12T18:00:30Z"), At("2006-03-12T18:05:30Z"), At("2006-03-12T18:10:30Z")};
const std::vector<Time> ends = {starts[0] + 280s, starts[1] + 280s, starts[2] + 280s};

} // namespace

TEST(FindBracket, TakesTheVolumesJustBeforeAndAfter)
{
  EXPECT_EQ(FindBracket(starts, At("2006-03-12T18:07Z"), 15min), (Indices{1, 2}));
}

TEST(FindBracket, AVolumeAtTheTimeIsBefore)
{
  EXPECT_EQ(FindBracket(starts, starts[1], 15min), (Indices{1, 2}));
}

TEST(FindBracket, HasOneSideAtTheEnds)
{
  EXPECT_EQ(FindBracket(starts, At("2006-03-12T18:00Z"), 15min), Indices{0});
  EXPECT_EQ(FindBracket(starts, At("2006-03-12T18:20Z"), 15min), Indices{2});
}

TEST(FindBracket, TheGapIsInclusive)
{
  EXPECT_EQ(FindBracket(starts, starts[2] + 15min, 15min), Indices{2});
  EXPECT_EQ(FindBracket(starts, starts[2] + 15min + 1ms, 15min), Indices{});
  EXPECT_EQ(FindBracket(starts, starts[0] - 15min, 15min), Indices{0});
  EXPECT_EQ(FindBracket(starts, starts[0] - 15min - 1ms, 15min), Indices{});
}

TEST(FindBracket, WithoutVolumesThereIsNone)
{
  EXPECT_EQ(FindBracket({}, starts[0], 15min), Indices{});
}

TEST(FindVolumesAbout, AVolumeInProgressStandsBetweenItsNeighbours)
{
  EXPECT_EQ(FindVolumesAbout(starts, ends, starts[1] + 60s, 15min), (Indices{0, 1, 2}));
  // Its last ray is in: what was before it matters no more.
  EXPECT_EQ(FindVolumesAbout(starts, ends, ends[1], 15min), (Indices{1, 2}));
  EXPECT_EQ(FindVolumesAbout({}, {}, starts[0], 15min), Indices{});
}

TEST(FindVolumesAbout, TheGapCountsFromTheNearerEndOfAVolume)
{
  EXPECT_EQ(FindVolumesAbout(starts, ends, ends[2] + 15min, 15min), (Indices{1, 2}));
  EXPECT_EQ(FindVolumesAbout(starts, ends, ends[2] + 15min + 1ms, 15min), Indices{});
  EXPECT_EQ(FindVolumesAbout(starts, ends, starts[0] - 15min, 15min), (Indices{0, 1}));
  EXPECT_EQ(FindVolumesAbout(starts, ends, starts[0] - 15min - 1ms, 15min), Indices{});
}

// Before the first volume and after the last, and in a pause over which motion is not known, two
// volumes on one side tell how echo moves.
TEST(FindVolumesAbout, OneVolumeMoreTellsTheMotion)
{
  EXPECT_EQ(FindVolumesAbout(starts, ends, starts[0] - 60s, 15min), (Indices{0, 1}));
  EXPECT_EQ(FindVolumesAbout(starts, ends, ends[2] + 60s, 15min), (Indices{1, 2}));
  EXPECT_EQ(FindVolumesAbout(starts, ends, ends[2] + 60s, 4min), (Indices{2})); // gone before
  EXPECT_EQ(FindVolumesAbout({starts[0]}, {ends[0]}, ends[0] + 60s, 15min), (Indices{0}));
  // 13 minutes between the third volume and the fourth, and 23; a fifth.
  for (const bool near : {true, false})
  {
    std::vector<Time> begin = starts;
    std::vector<Time> end = ends;
    for (const Duration after : {Duration(near ? 18min : 28min), Duration(near ? 23min : 33min)})
    {
      begin.push_back(starts[2] + after);
      end.push_back(ends[2] + after);
    }
    const Time pause = near ? ends[2] + 7min : ends[2] + 10min;
    EXPECT_EQ(
      FindVolumesAbout(begin, end, pause, 15min), near ? (Indices{2, 3}) : (Indices{1, 2, 3}));
    EXPECT_EQ(FindVolumesAbout(begin, end, begin[3] - 1min, 5min), (Indices{3, 4}));
  }
}

// A volume that began and is not chosen is not chosen again: a run may drop it.
TEST(FindVolumesAbout, WhatIsDroppedIsNotTakenAgain)
{
  for (const Duration length : {Duration(2min), Duration(280s), Duration(11min)})
  {
    for (const Duration gap : {Duration(1s), Duration(3min), Duration(8min), Duration(15min)})
    {
      std::vector<Time> begin;
      std::vector<Time> end;
      for (const Duration at : {0min, 12min, 24min, 50min, 64min, 120min, 132min, 150min})
      {
        begin.push_back(starts[0] + at);
        end.push_back(begin.back() + length);
      }
      std::vector<bool> dropped(begin.size(), false);
      for (Time time = begin[0] - 30min; time < end.back() + 30min; time += 10s)
      {
        std::vector<bool> chosen(begin.size(), false);
        for (const std::size_t index : FindVolumesAbout(begin, end, time, gap))
        {
          chosen[index] = true;
          ASSERT_FALSE(dropped[index]) << index << ' ' << FormatIso8601(time);
        }
        for (std::size_t i = 0; i < begin.size(); ++i)
        {
          dropped[i] = dropped[i] || (begin[i] <= time && !chosen[i]);
        }
      }
    }
  }
}

TEST(TimeSteps, AreMultiplesOfTheStepInsideTheSpan)
{
  const auto steps = TimeSteps(At("2006-03-12T18:00:01Z"), At("2006-03-12T18:15:00Z"), 5min);
  ASSERT_EQ(steps.size(), 3u);
  EXPECT_EQ(steps.front(), At("2006-03-12T18:05Z"));
  EXPECT_EQ(steps.back(), At("2006-03-12T18:15Z"));
}

TEST(TimeSteps, BothEndsAreInclusive)
{
  EXPECT_EQ(TimeSteps(At("2006-03-12T18:00Z"), At("2006-03-12T18:10Z"), 5min).size(), 3u);
  EXPECT_EQ(TimeSteps(At("2006-03-12T18:00Z"), At("2006-03-12T18:00Z"), 5min).size(), 1u);
}

TEST(TimeSteps, MayBeNone)
{
  EXPECT_TRUE(TimeSteps(At("2006-03-12T18:00:01Z"), At("2006-03-12T18:04:59Z"), 5min).empty());
}

TEST(TimeSteps, CountFrom1970AlsoBackwards)
{
  const auto steps = TimeSteps(At("1969-12-31T23:52Z"), At("1970-01-01T00:07Z"), 5min);
  ASSERT_EQ(steps.size(), 3u);
  EXPECT_EQ(steps[0], At("1969-12-31T23:55Z"));
  EXPECT_EQ(steps[1], At("1970-01-01"));
}

TEST(TimeSteps, RefusesWhatNeverEnds)
{
  EXPECT_THROW(TimeSteps(starts[0], starts[2], 0ms), Error);
  EXPECT_THROW(TimeSteps(starts[0], starts[2], -5min), Error);
  EXPECT_THROW(TimeSteps(starts[2], starts[0], 5min), Error);
  EXPECT_THROW(TimeSteps(At("1991-01-01"), At("2021-01-01"), 1ms), Error);
}

TEST(MiddleTime, IsAWholeSecondBetweenTheTimes)
{
  EXPECT_EQ(MiddleTime(At("2006-03-12T18:00:00.300Z"), At("2006-03-12T18:00:03.400Z")),
    At("2006-03-12T18:00:01Z"));
  EXPECT_EQ(MiddleTime(starts[0] + 100ms, starts[0] + 300ms), starts[0] + 100ms);
  EXPECT_EQ(MiddleTime(starts[0], starts[0]), starts[0]);
}

TEST(FindPause, FindsWhatLiesDaysApart)
{
  const Time never = Time::min();
  const Time always = Time::max();
  const TimeSpan first = {starts[0], ends[0]};
  const TimeSpan second = {starts[1], ends[1]};
  const TimeSpan later = {starts[0] + 48h, ends[0] + 48h};
  EXPECT_FALSE(FindPause({}, never, always, 24h));
  EXPECT_FALSE(FindPause({first}, never, always, 24h));
  EXPECT_FALSE(FindPause({second, first}, never, always, 24h));
  const auto pause = FindPause({later, second, first}, never, always, 24h);
  ASSERT_TRUE(pause);
  EXPECT_EQ(pause->first, ends[1]);
  EXPECT_EQ(pause->last, starts[0] + 48h);
  EXPECT_FALSE(FindPause({later, second, first}, never, starts[0] + 47h, 24h));
  EXPECT_FALSE(FindPause({later, second, first}, ends[1] + 1ms, always, 24h));
  EXPECT_FALSE(FindPause({later, second, first}, never, always, 48h));
  // A long volume with others inside it leaves no pause.
  EXPECT_FALSE(FindPause({first, second, {starts[0], later.first}, later}, never, always, 24h));
}

// SPDX-License-Identifier: BSD-3-Clause
#include "Temporal/VolumeSelection.h"

#include "Model/Error.h"

#include <gtest/gtest.h>

using namespace nexrad;
using namespace std::chrono_literals;

namespace
{

Time At(const char* text)
{
  return *ParseIso8601(text);
}

const std::vector<Time> starts = {
  At("2006-03-12T18:00:30Z"), At("2006-03-12T18:05:30Z"), At("2006-03-12T18:10:30Z")};

} // namespace

TEST(FindBracket, TakesTheVolumesJustBeforeAndAfter)
{
  const VolumeBracket bracket = FindBracket(starts, At("2006-03-12T18:07Z"), 15min);
  EXPECT_EQ(bracket.before, 1u);
  EXPECT_EQ(bracket.after, 2u);
}

TEST(FindBracket, AVolumeAtTheTimeIsBefore)
{
  const VolumeBracket bracket = FindBracket(starts, starts[1], 15min);
  EXPECT_EQ(bracket.before, 1u);
  EXPECT_EQ(bracket.after, 2u);
}

TEST(FindBracket, HasOneSideAtTheEnds)
{
  const VolumeBracket early = FindBracket(starts, At("2006-03-12T18:00Z"), 15min);
  EXPECT_FALSE(early.before);
  EXPECT_EQ(early.after, 0u);
  const VolumeBracket late = FindBracket(starts, At("2006-03-12T18:20Z"), 15min);
  EXPECT_EQ(late.before, 2u);
  EXPECT_FALSE(late.after);
}

TEST(FindBracket, TheGapIsInclusive)
{
  EXPECT_EQ(FindBracket(starts, starts[2] + 15min, 15min).before, 2u);
  EXPECT_FALSE(FindBracket(starts, starts[2] + 15min + 1ms, 15min).before);
  EXPECT_EQ(FindBracket(starts, starts[0] - 15min, 15min).after, 0u);
  EXPECT_FALSE(FindBracket(starts, starts[0] - 15min - 1ms, 15min).after);
}

TEST(FindBracket, WithoutVolumesThereIsNone)
{
  const VolumeBracket bracket = FindBracket({}, starts[0], 15min);
  EXPECT_FALSE(bracket.before || bracket.after);
}

namespace
{

using Indices = std::vector<std::size_t>;

const std::vector<Time> ends = {starts[0] + 280s, starts[1] + 280s, starts[2] + 280s};

} // namespace

TEST(FindVolumesAbout, AVolumeInProgressStandsBetweenItsNeighbours)
{
  EXPECT_EQ(FindVolumesAbout(starts, ends, starts[1] + 60s, 15min), (Indices{0, 1, 2}));
  // Its last ray is in: what was before it matters no more.
  EXPECT_EQ(FindVolumesAbout(starts, ends, ends[1], 15min), (Indices{1, 2}));
  EXPECT_EQ(FindVolumesAbout(starts, ends, starts[0] - 60s, 15min), (Indices{0}));
  EXPECT_EQ(FindVolumesAbout(starts, ends, ends[2] + 60s, 15min), (Indices{2}));
  EXPECT_EQ(FindVolumesAbout({}, {}, starts[0], 15min), Indices{});
}

TEST(FindVolumesAbout, TheGapCountsFromTheNearerEndOfAVolume)
{
  EXPECT_EQ(FindVolumesAbout(starts, ends, ends[2] + 15min, 15min), (Indices{2}));
  EXPECT_EQ(FindVolumesAbout(starts, ends, ends[2] + 15min + 1ms, 15min), Indices{});
  EXPECT_EQ(FindVolumesAbout(starts, ends, starts[0] - 15min, 15min), (Indices{0}));
  EXPECT_EQ(FindVolumesAbout(starts, ends, starts[0] - 15min - 1ms, 15min), Indices{});
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

// SPDX-License-Identifier: BSD-3-Clause
#include "nexrad/Live/LiveSeries.h"

#include "Scans/RadarsOfMissouri.h"

#include <gtest/gtest.h>

#include <string>

using namespace nexrad;
using nexrad::testing::noon;
using namespace std::chrono_literals;

namespace
{

// A volume of a minute; of one without its end two minutes are left.
ScannedFile FileOf(const std::string& name, Time start, bool hasEnd)
{
  SeriesVolume volume;
  volume.file = name;
  volume.start = start;
  volume.end = start + 1min;
  volume.begun = true;
  volume.left = hasEnd ? Duration() : Duration(2min);
  ScannedFile file;
  file.volumes.push_back({{"KEAX", {}}, volume});
  file.problems.push_back({name, {}, "some other damage"});
  if (!hasEnd)
  {
    file.problems.push_back({name, {}, "no end of volume", false, true});
  }
  return file;
}

} // namespace

TEST(AwaitedEnds, ARestartIsANoteAndALossAProblem)
{
  for (const Duration pause : {Duration(30s), Duration(90s)})
  {
    AwaitedEnds ends;
    Catalogue known;
    ScannedFile first = FileOf("a", noon, false);
    ends.Keep(first);
    ASSERT_EQ(first.problems.size(), 1U);
    EXPECT_EQ(first.problems[0].what, "some other damage");
    EXPECT_TRUE(ends.TakeDecided(known, {}).problems.empty()) << "the next volume may tell";
    ScannedFile next = FileOf("b", noon + 1min + pause, true);
    ends.Keep(next);
    for (const ScannedFile& file : {first, next})
    {
      known.Of(file.volumes[0].first).Put(file.volumes[0].second);
    }
    const AwaitedEnds::Decided decided = ends.TakeDecided(known, {});
    EXPECT_EQ(decided.notes.size(), pause < 1min ? 1U : 0U);
    ASSERT_EQ(decided.problems.size(), pause < 1min ? 0U : 1U);
    EXPECT_TRUE(decided.problems.empty() || decided.problems[0].isMissingEnd);
    const AwaitedEnds::Decided again = ends.TakeDecided(known, {"KEAX"});
    EXPECT_TRUE(again.notes.empty() && again.problems.empty()) << "each is said once";
  }
}

TEST(AwaitedEnds, OfASilentRadarAreLost)
{
  AwaitedEnds ends;
  ScannedFile file = FileOf("a", noon, false);
  ends.Keep(file);
  EXPECT_TRUE(ends.TakeDecided({}, {"KLSX"}).problems.empty());
  EXPECT_EQ(ends.TakeDecided({}, {"KEAX"}).problems.size(), 1U);
}

TEST(AwaitedEnds, CanComeWithTheRestOfTheFile)
{
  AwaitedEnds ends;
  ScannedFile part = FileOf("a", noon, false);
  ends.Keep(part);
  ScannedFile whole = FileOf("a", noon, true);
  ends.Keep(whole);
  const AwaitedEnds::Decided decided = ends.TakeDecided({}, {"KEAX"});
  EXPECT_TRUE(decided.problems.empty() && decided.notes.empty());
}

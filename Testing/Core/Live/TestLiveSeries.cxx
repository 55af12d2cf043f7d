// SPDX-License-Identifier: BSD-3-Clause
#include "nexrad/Live/LiveSeries.h"

#include "Feed/ChunkMaker.h"
#include "Scans/RadarsOfMissouri.h"
#include "TestData.h"
#include "nexrad/Level2/Level2File.h"
#include "nexrad/Live/ChunkedVolume.h"
#include "nexrad/Merging/SeriesMerger.h"
#include "nexrad/System/Error.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <memory>
#include <random>

using namespace nexrad;
using namespace nexrad::testing;
using namespace std::chrono_literals;
namespace fs = std::filesystem;

namespace
{

/// Half an hour of two radars (synthetic), a folder of chunks for each volume.
class LiveMerges : public ::testing::Test
{
protected:
  LiveMerges()
  {
    for (int i = 0; i < 6; ++i)
    {
      this->Write(keax, i, start + i * 5min, 10.0 + i);
      this->Write(klsx, i, start + i * 6min + 20s, 30.0 + i);
    }
    options.grid.dimensions = {32, 16, 8};
    options.grid.range = 100'000.0;
    options.step = 2min;
    options.quality.level = QualityLevel::Off; // rays of one value are a fault of the receiver
  }

  void Write(const Site& site, int number, Time time, double value)
  {
    const fs::path path = folder.Path() / site.name / std::to_string(number);
    WriteChunks(path, CutIntoChunks(VolumeOfSweeps(site, time, 3, value)));
    folders.push_back(path);
  }

  static LiveInput Whole(const fs::path& path)
  {
    return {path.string(), path, ReadLevel2(path), true};
  }

  void ExpectAsGrid(LiveSeries& series) const
  {
    SeriesMerger merger({folder.Path()}, options);
    ASSERT_TRUE(merger.Open());
    EXPECT_EQ(series.Grid(), merger.Grid());
    for (const Time time : merger.Times())
    {
      const auto expected = merger.Merge(time);
      const auto made = series.Merge(time);
      ASSERT_TRUE(expected && made);
      EXPECT_TRUE(made->values == expected->values) << FormatIso8601(time);
      EXPECT_TRUE(made->states == expected->states) << FormatIso8601(time);
      EXPECT_EQ(made->sites, expected->sites);
    }
  }

  const TemporaryFolder folder;
  std::vector<fs::path> folders;
  MergeOptions options;
};

} // namespace

TEST_F(LiveMerges, AreThoseOfTheFinishedFilesWhateverTheOrder)
{
  std::mt19937 random(16);
  for (int attempt = 0; attempt < 3; ++attempt)
  {
    std::shuffle(folders.begin(), folders.end(), random);
    LiveSeries series(options, {});
    for (const fs::path& path : folders)
    {
      // First a part of it, as it would be while it arrives.
      LiveInput part = Whole(path);
      part.volume.sweeps.resize(1 + random() % 2);
      part.finished = false;
      series.Put({part});
      series.Merge(*series.Known().Last());
      series.Put({Whole(path)});
    }
    this->ExpectAsGrid(series);
  }
}

TEST_F(LiveMerges, OfSeveralMomentsToo)
{
  options.moments = {MomentName::REF, MomentName::VEL};
  LiveSeries series(options, ThreadLoop(2));
  std::vector<LiveInput> inputs;
  for (const fs::path& path : folders)
  {
    inputs.push_back(Whole(path));
  }
  for (const ScannedFile& file : series.Put(inputs))
  {
    ASSERT_EQ(file.problems.size(), 1U);
    EXPECT_EQ(file.problems[0].what, "no ray has VEL");
  }
  EXPECT_EQ(series.Known().Spans().size(), 12U);
  this->ExpectAsGrid(series);
}

// A volume in progress has its new sweeps low, and those of the volume before high.
TEST_F(LiveMerges, AVolumeInProgressLeavesTheUpperTiltsToTheOneBefore)
{
  LiveSeries series(options, {});
  series.Put({Whole(folder.Path() / "KEAX" / "0")});
  LiveInput part = Whole(folder.Path() / "KEAX" / "1");
  part.volume.sweeps.resize(1);
  part.finished = false;
  series.Put({part});
  const Time newest = *series.Known().Last();
  EXPECT_EQ(newest, part.volume.sweeps[0].rays.back().time);
  const std::string inputs = series.InputsAt(newest);
  EXPECT_NE(inputs.find("2006-03-12T18:00:00.000Z"), std::string::npos) << inputs;
  EXPECT_NE(inputs.find("2006-03-12T18:05:00.000Z"), std::string::npos) << inputs;
  const auto merged = series.Merge(newest);
  ASSERT_TRUE(merged);
  std::size_t low = 0;
  std::size_t high = 0;
  for (std::size_t i = 0; i < merged->values.size(); ++i)
  {
    low += merged->values[i] == 11.0F ? 1 : 0;  // lowest sweep, of the second volume
    high += merged->values[i] == 12.0F ? 1 : 0; // highest sweep, of the first
  }
  EXPECT_GT(low, 0U);
  EXPECT_GT(high, 0U);
}

TEST_F(LiveMerges, ATimeIsSettledWhenEachRadarHasGoneOn)
{
  LiveSeries series(options, {});
  series.Put({Whole(folder.Path() / "KEAX" / "0"), Whole(folder.Path() / "KLSX" / "0")});
  EXPECT_FALSE(series.IsSettled(start + 2min, {}));
  EXPECT_TRUE(series.IsSettled(start + 2min, {"KEAX", "KLSX"}));
  LiveInput next = Whole(folder.Path() / "KEAX" / "1");
  next.finished = false;
  series.Put({next});
  EXPECT_FALSE(series.IsSettled(start + 2min, {"KLSX"}));
  next.finished = true;
  series.Put({next});
  EXPECT_TRUE(series.IsSettled(start + 2min, {"KLSX"}));
  EXPECT_FALSE(series.IsSettled(start + 2min, {}));
}

TEST_F(LiveMerges, ForgetWhatNoLaterTimeNeeds)
{
  LiveSeries series(options, {});
  for (const fs::path& path : folders)
  {
    series.Put({Whole(path)});
  }
  EXPECT_EQ(series.Known().Spans().size(), 12U);
  SeriesMerger merger({folder.Path()}, options);
  ASSERT_TRUE(merger.Open());
  const Time from = start + 20min;
  series.Forget(from);
  EXPECT_LT(series.Known().Spans().size(), 8U);
  for (Time time = from; time <= start + 28min; time += 2min)
  {
    EXPECT_TRUE(series.Merge(time)->values == merger.Merge(time)->values) << FormatIso8601(time);
  }
}

TEST_F(LiveMerges, TheDomainGrowsUntilItIsKept)
{
  LiveSeries series(options, {});
  EXPECT_FALSE(series.HasGrid());
  series.Put({Whole(folder.Path() / "KEAX" / "0")});
  const GridSpecification one = series.Grid();
  LiveSeries kept(options, {});
  kept.Put({Whole(folder.Path() / "KEAX" / "0")});
  kept.KeepGrid();
  for (LiveSeries* each : {&series, &kept})
  {
    each->Put({Whole(folder.Path() / "KLSX" / "0")});
  }
  EXPECT_FALSE(series.Grid() == one);
  EXPECT_TRUE(kept.Grid() == one);
  // A run that goes on knows the radars before they send anything.
  LiveSeries next(options, {});
  for (const auto& [name, site] : series.Sites())
  {
    next.Expect(site.first, site.second);
  }
  EXPECT_TRUE(next.Grid() == series.Grid());
}

// The lowest tilt of a terminal radar, which comes first, reaches farther than the others do.
TEST_F(LiveMerges, TheRangeOfATerminalRadarIsThatOfItsWholeFirstVolume)
{
  NEXRAD_REQUIRE_TEST_DATA(data);
  const fs::path path = data / "level2" / "chunks" / "TORD-20260811";
  options.grid.range.reset();
  SeriesMerger merger({path}, options);
  ASSERT_TRUE(merger.Open());
  LiveSeries series(options, {});
  LiveInput part = Whole(path);
  part.volume.sweeps.resize(2);
  part.finished = false;
  series.Put({part});
  EXPECT_FALSE(series.Grid() == merger.Grid());
  series.Put({Whole(path)});
  EXPECT_TRUE(series.Grid() == merger.Grid());
  // A later volume, which has just begun, changes nothing.
  LiveInput next = part;
  next.key = "next";
  for (Sweep& sweep : next.volume.sweeps)
  {
    for (Ray& ray : sweep.rays)
    {
      ray.time += 6min;
    }
  }
  series.Put({next});
  EXPECT_TRUE(series.Grid() == merger.Grid());
}

// The second of two radars of one name never stands at the place of the first.
TEST_F(LiveMerges, ANamesakeFarAwayIsAProblem)
{
  LiveSeries series(options, {});
  LiveInput other = Whole(folders[2]);
  other.volume.site.position->latitude += 3.0;
  EXPECT_TRUE(series.Put({Whole(folders[0])}).at(0).problems.empty());
  const auto scanned = series.Put({other});
  ASSERT_EQ(scanned.at(0).problems.size(), 1U);
  EXPECT_TRUE(scanned[0].problems[0].leftOut);
  EXPECT_NE(scanned[0].problems[0].what.find("other files have it at 38.810"), std::string::npos)
    << scanned[0].problems[0].what;
  EXPECT_EQ(series.Known().Spans().size(), 1U);
}

TEST_F(LiveMerges, WhatCannotBeUsedIsAProblem)
{
  LiveSeries series(options, {});
  LiveInput none = Whole(folders.front());
  none.volume.sweeps.clear();
  none.volume.damage.push_back({0, "no ray can be read"});
  const auto scanned = series.Put({none});
  ASSERT_FALSE(scanned.at(0).problems.empty());
  EXPECT_EQ(scanned[0].problems.back().what, "no ray could be read: left out");
  EXPECT_EQ(series.Known().Spans().size(), 0U);
  options.measureBiases = true;
  EXPECT_THROW(LiveSeries(options, {}), Error);
}

// The memory is enough for the radars that are there; the feed goes on without a further one.
TEST_F(LiveMerges, ARadarForWhichThereIsNoMemoryIsLeftOut)
{
  std::unique_ptr<LiveSeries> series;
  for (double mebibytes = 1.0; !series; mebibytes *= 1.1)
  {
    options.memoryLimit = {static_cast<std::size_t>(mebibytes * 1024.0 * 1024.0), "--memory"};
    try
    {
      auto made = std::make_unique<LiveSeries>(options, RangeLoop());
      made->Put({Whole(folders[0])});
      series = std::move(made);
    }
    catch (const Error&) // even one radar needs more
    {
      continue;
    }
  }
  for (int i = 0; i < 30; ++i)
  {
    const std::string name = "KX" + std::to_string(10 + i);
    this->Write({name, Position{38.0 + 0.1 * i, -94.0, 300.0}}, 0, start, 40.0);
    const fs::path path = folders.back();
    const ScannedFile scanned = series->Put({Whole(path)}).front();
    if (!scanned.problems.empty())
    {
      EXPECT_TRUE(scanned.problems.front().leftOut);
      EXPECT_EQ(scanned.problems.front().file, path.string());
      EXPECT_EQ(scanned.problems.front().what.rfind(name + " is left out: ", 0), 0U);
      EXPECT_EQ(series->Sites().count(name), 0U);
      EXPECT_EQ(series->InputsAt(start + 4min).find(name), std::string::npos);
      return;
    }
  }
  FAIL() << "thirty radars fit where hardly one did";
}

TEST_F(LiveMerges, ARadarWhoseVolumesAreTakenOutLeavesTheDomain)
{
  LiveSeries alone(options, {});
  alone.Put({Whole(folders[0])});
  LiveSeries series(options, {});
  series.Put({Whole(folders[0]), Whole(folders[1])});
  EXPECT_FALSE(series.Grid() == alone.Grid());
  series.Put({{folders[1].string(), folders[1], RadarVolume(), false}});
  EXPECT_EQ(series.Grid(), alone.Grid());
  EXPECT_EQ(series.Sites().count("KLSX"), 0U);
  EXPECT_EQ(series.Known().Spans().size(), 1U);
}

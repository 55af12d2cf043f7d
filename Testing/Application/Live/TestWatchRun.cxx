// SPDX-License-Identifier: BSD-3-Clause
// A run of `watch` whose volumes are stored in bricks, and what `grid` makes of the same files.
#include "Live/NewestBricks.h"
#include "Live/WatchRun.h"
#include "Volumes/WriteVolumes.h"

#include "Feed/ChunkMaker.h"
#include "Scans/RadarsOfMissouri.h"
#include "TestData.h"

#include <gtest/gtest.h>

using namespace nexrad;
using namespace nexrad::application;
using namespace nexrad::testing;
using namespace std::chrono_literals;
namespace fs = std::filesystem;

namespace
{

void Ignore(const std::string&) {}

} // namespace

// Large volumes are made band after band: those of the time steps have the bytes that `grid` gives
// them, and the newest one is stored alike.
TEST(WatchRun, KeepsLargeVolumesInBricks)
{
  const TemporaryFolder folder;
  for (int i = 0; i < 4; ++i)
  {
    for (const Site& site : {keax, klsx})
    {
      WriteChunks(folder.Path() / "in" / site.name / std::to_string(i + 1),
        CutIntoChunks(VolumeOfSweeps(site, start + i * 5min, 2, 10.0 + i)));
    }
  }
  GridJob expected;
  expected.inputs = {folder.Path() / "in"};
  expected.folder = folder.Path() / "grid";
  expected.written.largestWhole = 1000;
  expected.options.grid.dimensions = {70, 150, 10};
  expected.options.grid.range = 150'000.0;
  expected.options.step = 5min;
  expected.options.quality.level = QualityLevel::Off; // rays of one value are a receiver's fault
  WriteVolumes(expected, {}, {});

  WatchJob job;
  job.folders = expected.inputs;
  job.output = folder.Path() / "watch";
  job.written = expected.written;
  job.options = expected.options;
  job.stopAfter = 1s;
  const WatchReport report = WatchFolders(job, Ignore, Ignore);

  std::size_t steps = 0;
  for (const auto& entry : fs::directory_iterator(expected.folder))
  {
    const std::string content = FileContent(entry.path());
    EXPECT_TRUE(FileContent(job.output / entry.path().filename()) == content) << entry.path();
    steps += content.find("\"encoding\":\"bricks\"") != std::string::npos ? 1 : 0;
  }
  EXPECT_EQ(steps, 4U);
  EXPECT_EQ(report.steps, steps) << "each once, for all files were there from the start";
  EXPECT_NE(
    FileContent(job.output / "newest.nxv").find("\"encoding\":\"bricks\""), std::string::npos);
}

// The volume ahead of the newest ray takes sweeps up, and has the bytes of one that is merged as a
// whole; beyond its time, the next one is.
TEST(NewestBricks, TakeASweepUp)
{
  const TemporaryFolder folder;
  MergeOptions options;
  options.grid.dimensions = {600, 150, 10}; // a coarser level, too
  options.grid.range = 150'000.0;
  options.interpolation = TimeInterpolationMethod::Linear;
  options.quality.level = QualityLevel::Off;
  LiveSeries series(options, {});
  const auto put = [&series](const Site& site, Time time, int sweeps, double value)
  {
    const std::string key = site.name + FormatIso8601(time);
    series.Put({{key, key, VolumeOfSweeps(site, time, sweeps, value), true}});
  };
  put(keax, start, 3, 20.0);
  put(klsx, start, 3, 30.0);
  series.KeepGrid();

  NewestBricks newest(series, folder.Path() / "newest.nxv", {});
  const Time ahead = newest.TimeFor(*series.Known().Last(), 5min);
  EXPECT_GE(ahead - *series.Known().Last(), 1min);
  EXPECT_EQ(ahead.time_since_epoch() % 1min, 0min);
  const Time time = start + 9min;
  const Progress stop = [](double) { return false; };
  EXPECT_FALSE(newest.Make(time, stop)) << "the first is merged as a whole";
  ASSERT_TRUE(newest.Make(time, {}));
  const std::string first = FileContent(folder.Path() / "newest.nxv");

  put(keax, *series.Known().Last() + 1s, 1, 40.0);
  ASSERT_LT(*series.Known().Last(), time);
  EXPECT_EQ(newest.TimeFor(*series.Known().Last(), 5min), time);
  EXPECT_TRUE(newest.Make(time, stop)) << "what changes is merged without a stop";
  NewestBricks other(series, folder.Path() / "whole.nxv", {});
  ASSERT_TRUE(other.Make(time, {}));
  const std::string made = FileContent(folder.Path() / "newest.nxv");
  EXPECT_TRUE(made == FileContent(folder.Path() / "whole.nxv"));
  EXPECT_TRUE(made != first);

  EXPECT_GT(newest.TimeFor(time + 1s, 5min), time);
  EXPECT_LE(newest.TimeFor(time + 1s, 5min), time + 7min);
}

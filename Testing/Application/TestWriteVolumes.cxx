// SPDX-License-Identifier: BSD-3-Clause
// Files merged as they are decoded against the merge of files that were all scanned before.
#include "ErrorMessage.h"
#include "Volumes/UnfinishedRun.h"
#include "Volumes/WriteVolumes.h"

#include "Comparison/VolumeComparison.h"
#include "DirectMerge.h"
#include "Filters/Series/VolumeFiles.h"
#include "HandMadeVolume.h"
#include "TestData.h"
#include "ThreadProcesses.h"
#include "Tolerance.h"
#include "nexrad/Codec/NxvFile.h"
#include "nexrad/Codec/NxvHeader.h"
#include "nexrad/Compression/Deflate.h"
#include "nexrad/System/Error.h"

#include <gtest/gtest.h>

#include <fstream>
#include <map>

using namespace nexrad;
using namespace nexrad::application;
using namespace nexrad::testing;
using namespace std::chrono_literals;
namespace fs = std::filesystem;

namespace
{

/// Forty minutes of two radars whose circles overlap; each volume has a value of its own.
class WritingVolumes : public ::testing::Test
{
protected:
  WritingVolumes()
  {
    const Site keax = {"KEAX", Position{38.81, -94.264, 333.0}};
    const Site near = {"KNEA", Position{38.9, -93.4, 300.0}};
    for (int i = 0; i < 8; ++i)
    {
      this->Write("e" + std::to_string(i), keax, start + i * 5min, 10.0 + i);
      this->Write("n" + std::to_string(i), near, start + i * 6min + 40s, 30.0 + i);
    }
    job.inputs = {folder.Path() / "in"};
    job.options.grid.dimensions = {40, 24, 10};
    job.options.grid.range = 100'000.0;
    job.options.step = 3min;
    job.options.quality.level =
      QualityLevel::Off; // rays that hold one value are a fault of the receiver
  }

  void Write(const std::string& name, const Site& site, Time time, double value)
  {
    fs::create_directories(folder.Path() / "in");
    files.push_back(WriteLevel2(folder.Path() / "in" / name, {ConstantVolume(site, time, value)}));
  }

  // The volume files, by their names, that a job makes, in so many processes.
  std::map<std::string, std::string> Contents(const std::string& output, std::size_t processes = 1)
  {
    job.folder = folder.Path() / output;
    report = AsProcesses(processes,
      [this](const Processes& each) {
        return WriteVolumes(job, {}, each);
      }).front();
    std::map<std::string, std::string> contents;
    for (const auto& entry : fs::directory_iterator(job.folder))
    {
      contents[entry.path().filename()] = entry.is_directory() ? "" : FileContent(entry.path());
    }
    contents.erase("volumes.nxv.series");
    return contents;
  }

  // The same from all files at once.
  std::map<std::string, std::string> Expected()
  {
    const DirectMerge direct(job.inputs, job.options);
    std::map<std::string, std::string> contents;
    const fs::path file = folder.Path() / "one.nxv";
    for (const Time time : direct.Times())
    {
      WriteNxv(file, direct.At(time));
      contents[VolumeFileName(time, VolumeFormat::Nxv)] = FileContent(file);
    }
    return contents;
  }

  const Time start = *ParseIso8601("2006-03-12T18:00:00Z");
  const TemporaryFolder folder;
  std::vector<fs::path> files;
  GridJob job;
  GridReport report;
};

} // namespace

TEST_F(WritingVolumes, AsAScanWould)
{
  const auto expected = this->Expected();
  ASSERT_EQ(expected.size(), 15U); // 18:00 to 18:42:47
  EXPECT_TRUE(this->Contents("beam") == expected);
  EXPECT_TRUE(report.problems.empty());
  EXPECT_EQ(report.files.size(), 15U);
  EXPECT_EQ(ReadNxv(report.files[5]).sites, (std::vector<std::string>{"KEAX", "KNEA"}));
  job.options.method = MergeMethod::Thesis;
  EXPECT_TRUE(this->Contents("thesis") == this->Expected());
  job.options.method = MergeMethod::Beam;
  job.options.begin = start + 10min;
  job.options.end = start + 17min;
  const auto part = this->Contents("part");
  EXPECT_EQ(part.size(), 2U);
  EXPECT_TRUE(part == this->Expected());
}

// Without a time step: one volume at its middle, and so what has no multiple of 5 minutes.
TEST_F(WritingVolumes, OneVolumeAloneIsMadeAtItsMiddle)
{
  job.options.step.reset();
  for (const std::size_t file : {std::size_t(0), std::size_t(1)})
  {
    job.inputs = {files[file]};
    const auto made = this->Contents("alone" + std::to_string(file));
    EXPECT_TRUE(made == this->Expected());
    ASSERT_EQ(made.size(), 1U);
    // From 18:00:00 or 18:00:40 on, a ray each 20 ms.
    EXPECT_EQ(made.begin()->first, file == 0 ? "20060312T180003Z.nxv" : "20060312T180043Z.nxv");
  }
  job.inputs = {files[1], files[0]};
  EXPECT_EQ(this->Contents("two").begin()->first, "20060312T180000Z.nxv"); // a multiple
  job.inputs = {files[1]};
  job.options.step = 5min;
  EXPECT_THROW(this->Contents("asked"), Error);
}

// Nobody wants the volumes of the years between two files.
TEST_F(WritingVolumes, DaysWithoutARayAskForTheBegin)
{
  const Site site = {"KEAX", Position{38.81, -94.264, 333.0}};
  this->Write("late", site, start + 24h * 365, 50.0);
  for (const bool headersKnow : {true, false})
  {
    if (!headersKnow)
    {
      SetHeaderTime(files.back(), start + 20min);
    }
    const std::string error = MessageOf([&] { this->Contents("years"); });
    EXPECT_NE(error.find("--begin"), std::string::npos) << error;
    EXPECT_TRUE(!fs::exists(folder.Path() / "years") || fs::is_empty(folder.Path() / "years"));
  }
  job.options.end = start + 1h;
  EXPECT_EQ(this->Contents("first").size(), 21U); // to 19:00
  job.options.end.reset();
  job.options.begin = start + 24h * 364;
  EXPECT_NO_THROW(this->Contents("second"));
}

// The domain of a terminal radar alone is what it sees.
TEST_F(WritingVolumes, OneTerminalRadarHasTheDomainOfItsReach)
{
  const Site terminal = {"TDAL", Position{32.926, -96.968, 190.0}};
  files.push_back(WriteLevel2(folder.Path() / "terminal", {ConstantVolume(terminal, start, 20.0)}));
  job.options = MergeOptions();
  job.options.grid.dimensions = {40, 24, 10};
  int runs = 0;
  const auto widthOf = [this, &runs](const std::vector<fs::path>& inputs)
  {
    job.inputs = inputs;
    this->Contents("domain" + std::to_string(runs++));
    const GriddedVolume made = ReadNxv(report.files.front());
    return made.grid.spacing[0] * made.grid.dimensions[0];
  };
  EXPECT_WITHIN(widthOf({files.back()}), 200'000.0, 4.0,
    "width of the grid of the terminal radar, m"); // 99.5 km, in whole km
  EXPECT_WITHIN(
    widthOf({files.front()}), 460'000.0, 4.0, "width of the grid of the other radar, m");
  EXPECT_AT_LEAST(
    widthOf({files.front(), files.back()}), 460'000.0, "width of the grid of both radars, m");
  job.options.grid.range = 50'000.0;
  EXPECT_WITHIN(
    widthOf({files.back()}), 100'000.0, 2.0, "width of the grid at a range of 50 km, m");
  job.options.grid.range = 230'000.0;
  EXPECT_WITHIN(
    widthOf({files.back()}), 460'000.0, 4.0, "width of the grid at a range of 230 km, m");
}

TEST_F(WritingVolumes, HeadersThatErrMakeNoDifference)
{
  const auto expected = this->Expected();
  SetHeaderTime(files[4], start + 3h);
  SetHeaderTime(files[9], start - 2h);
  EXPECT_TRUE(this->Contents("err") == expected);
  BlankHeaderName(files[1]);
  EXPECT_TRUE(this->Contents("nameless") == expected);
}

TEST_F(WritingVolumes, WhatIsDamagedIsNamedInTheOrderOfTheInputs)
{
  fs::resize_file(files[6], fs::file_size(files[6]) - 30'000);
  fs::resize_file(files[3], 30);
  const auto expected = this->Expected();
  EXPECT_TRUE(this->Contents("damaged") == expected);
  const std::vector<InputProblem> problems = DirectMerge(job.inputs, job.options).Scan().problems;
  ASSERT_EQ(report.problems.size(), problems.size());
  EXPECT_AT_LEAST(report.problems.size(), 3U, "problems named");
  for (std::size_t i = 0; i < report.problems.size(); ++i)
  {
    EXPECT_EQ(report.problems[i], problems[i].Line());
  }
}

TEST_F(WritingVolumes, AStopLeavesNoIndex)
{
  job.folder = folder.Path() / "stopped";
  const auto stop = [](double done) { return done < 0.5; };
  EXPECT_THROW(WriteVolumes(job, stop), Error);
  EXPECT_FALSE(fs::exists(job.folder / "volumes.nxv.series"));
}

// Before, the volumes of a run that failed took the place of older ones and were then removed.
TEST_F(WritingVolumes, AFailureChangesNothingThatWasThere)
{
  job.options.end = start + 10min;
  const auto before = this->Contents("kept");
  ASSERT_EQ(before.size(), 4U);
  const std::string index = FileContent(report.indices.front());
  job.options.method = MergeMethod::Thesis;
  job.options.maximumGap = 1s; // none of these steps is that near to a volume
  job.options.begin = start + 3min;
  job.options.end = start + 9min;
  EXPECT_THROW(this->Contents("kept"), Error);
  job.options.maximumGap = 15min;
  const auto stop = [](double done) { return done < 0.5; };
  EXPECT_THROW(WriteVolumes(job, stop), Error);
  std::size_t kept = 0;
  for (const auto& entry : fs::directory_iterator(job.folder))
  {
    const std::string name = entry.path().filename();
    kept += before.count(name);
    EXPECT_NE(name.front(), '.') << name;
    if (before.count(name) > 0)
    {
      EXPECT_TRUE(FileContent(entry.path()) == before.at(name)) << name;
    }
  }
  EXPECT_EQ(kept, before.size());
  EXPECT_EQ(FileContent(report.indices.front()), index);
}

TEST_F(WritingVolumes, ARunThatSucceedsReplacesWhatWasThere)
{
  job.options.end = start + 10min;
  const auto beam = this->Contents("replaced");
  job.options.method = MergeMethod::Thesis;
  const auto expected = this->Contents("thesis");
  EXPECT_FALSE(expected == beam);
  EXPECT_TRUE(this->Contents("replaced") == expected);
}

// Volumes of two grids in one folder were drawn as one series.
TEST_F(WritingVolumes, AFolderWithTwoGridsIsNotDrawn)
{
  job.options.end = start + 10min;
  this->Contents("first");
  job.options.begin = start + 20min;
  job.options.end = start + 30min;
  job.options.grid.dimensions = {20, 24, 10};
  this->Contents("second");
  fs::copy(folder.Path() / "second", folder.Path() / "first",
    fs::copy_options::recursive | fs::copy_options::skip_existing);
  const std::string text = MessageOf([&] { OpenVolumeFiles({folder.Path() / "first"}); });
  EXPECT_NE(text.find("20060312T180000Z.nxv has 40x24x10"), std::string::npos) << text;
  EXPECT_NE(text.find("20060312T182100Z.nxv has 20x24x10"), std::string::npos) << text;
  EXPECT_EQ(OpenVolumeFiles({folder.Path() / "first" / "volumes.nxv.series"})->Times().size(), 4U);
}

// 681 million voxels in 500 bytes; the picture of them would take ten gigabytes.
TEST(OpeningVolumes, AVolumeTooLargeToDrawIsRefused)
{
  const TemporaryFolder folder;
  const fs::path path = folder.Path() / "cube.nxv";
  NxvHeader header;
  header.volume.grid.dimensions = {880, 880, 880};
  header.volume.time = *ParseIso8601("2006-03-12T18:00:00Z");
  header.volume.method = "beam";
  NxvArray array;
  array.name = "REF";
  array.unit = "dBZ";
  array.length = 5;
  const std::string run("\0\0\xA8\x9E\x28", 5); // 681 472 000 times the code 0
  array.crc32 = Crc32(reinterpret_cast<const std::uint8_t*>(run.data()), run.size());
  header.arrays = {array};
  const std::string text = FormatNxvHeader(header);
  std::string start = "NXV1....";
  for (unsigned byte = 0; byte < 4; ++byte)
  {
    start[4 + byte] = static_cast<char>(text.size() >> (8 * byte) & 0xFF);
  }
  std::ofstream(path, std::ios::binary) << start << text << run;
  const auto series = OpenVolumeFiles({path});
  const std::string problem = MessageOf([&] { series->Load(0, {}); });
  EXPECT_NE(problem.find("681472000 voxels of 11 bytes"), std::string::npos) << problem;
}

// Large volumes are made band after band and stored in bricks: they hold what the others hold.
TEST_F(WritingVolumes, InBricksTheSame)
{
  job.options.grid.dimensions = {70, 150, 10};
  job.options.step = 10min;
  const auto whole = this->Contents("whole");
  job.written.largestWhole = 1000;
  const auto bricks = this->Contents("bricks");
  ASSERT_EQ(bricks.size(), whole.size());
  for (const auto& [name, content] : whole)
  {
    ExpectSameVolume(
      ReadNxv(folder.Path() / "bricks" / name), ReadNxv(folder.Path() / "whole" / name));
    EXPECT_NE(bricks.at(name), content);
    EXPECT_NE(bricks.at(name).find("\"encoding\":\"bricks\""), std::string::npos);
  }
  // Not those of each radar, nor of NetCDF.
  job.perRadar = true;
  EXPECT_EQ(this->Contents("radars").begin()->second.find("bricks"), std::string::npos);
}

// Each process makes rows of each volume of bricks; of more processes than parts of 128 rows, some
// make none.
TEST_F(WritingVolumes, SeveralProcessesMakeAVolumeInBricksTogether)
{
  job.options.grid.dimensions = {70, 300, 10};
  job.options.step = 10min;
  job.written.largestWhole = 1000;
  const auto expected = this->Contents("alone");
  EXPECT_EQ(expected.size(), 5U);
  for (const std::size_t processes : {std::size_t(2), std::size_t(3), std::size_t(5)})
  {
    EXPECT_TRUE(this->Contents("by-" + std::to_string(processes), processes) == expected);
    EXPECT_FALSE(fs::exists(job.folder / UnfinishedRun::HiddenName));
    EXPECT_EQ(report.files.size(), 5U);
  }
  // Also where all files are scanned first, to compare the radars.
  job.options.measureBiases = true;
  const auto compared = this->Contents("compared");
  EXPECT_TRUE(this->Contents("compared-by-2", 2) == compared);
  job.options.measureBiases = false;
  // Also where a header errs, which one process finds out.
  this->Write("late", {"KEAX", Position{38.81, -94.264, 333.0}}, start + 17min, 55.0);
  SetHeaderTime(files.back(), start + 33min);
  const auto erring = this->Contents("erring");
  EXPECT_FALSE(erring == expected);
  EXPECT_TRUE(this->Contents("erring-by-2", 2) == erring);
}

// Of processes with different options, nobody waits for what the others do not do.
TEST_F(WritingVolumes, ProcessesThatShareRowsNeedTheSameOptions)
{
  job.options.grid.dimensions = {70, 300, 10};
  job.written.largestWhole = 1000;
  job.folder = folder.Path() / "out";
  GridJob other = job;
  other.recipe = "another step";
  GridJob small = job;
  small.written.largestWhole = 1'000'000;
  for (const GridJob& second : {other, small})
  {
    const auto outcomes = AsProcesses(2, [&](const Processes& each)
      { return MessageOf([&] { WriteVolumes(each.IsFirst() ? job : second, {}, each); }); });
    for (const std::string& outcome : outcomes)
    {
      EXPECT_EQ(outcome, "the processes do not make the same volumes; all need the same options");
    }
  }
  EXPECT_FALSE(fs::exists(job.folder));
}

TEST_F(WritingVolumes, AFailureOfOneWhileRowsAreSharedFailsAll)
{
  job.options.grid.dimensions = {70, 300, 10};
  job.options.step = 10min;
  job.written.largestWhole = 1000;
  const auto expected = this->Contents("alone");
  // Where the second process has to write its rows of the third volume stands a folder.
  const auto third = std::next(expected.begin(), 2)->first;
  job.folder = folder.Path() / "out";
  const fs::path inTheWay = job.folder / UnfinishedRun::HiddenName / ("." + third + ".part-1");
  fs::create_directories(inTheWay / "full");
  std::ofstream(job.folder / UnfinishedRun::HiddenName / UnfinishedRun::LockName);
  job.recipe = "the same";
  EXPECT_NE(MessageOf([&] { this->Contents("out", 3); }).find(".part-1"), std::string::npos);
  EXPECT_TRUE(fs::exists(job.folder / expected.begin()->first));
  EXPECT_FALSE(fs::exists(job.folder / "volumes.nxv.series"));
  fs::remove_all(inTheWay);
  EXPECT_TRUE(this->Contents("out", 2) == expected);
}

/// Tasks that make five volumes in bricks, of three parts of 128 rows.
class MakingTasks : public WritingVolumes
{
protected:
  MakingTasks()
  {
    job.options.grid.dimensions = {70, 300, 10};
    job.options.step = 10min;
    job.written.largestWhole = 1000;
    job.folder = folder.Path() / "out";
  }

  // The error of a task; none when it is done.
  std::string Run(const std::string& task)
  {
    job.task = ParseGridTask(task);
    return MessageOf([this] { WriteVolumes(job); });
  }
};

// Tasks that run one after the other, without knowing of each other, make what one run makes.
TEST_F(MakingTasks, TasksMakeVolumesInBricksPartByPart)
{
  const auto expected = this->Contents("alone");
  for (const std::vector<std::string>& tasks : {std::vector<std::string>{"scan:1/1", "rows:1/1"},
         {"scan:2/3", "scan:1/3", "scan:3/3", "rows:2/2", "rows:1/2"},
         {"scan:1/2", "scan:2/2", "rows:5/5", "rows:4/5", "rows:3/5", "rows:2/5", "rows:1/5"}})
  {
    const std::string output = "by-" + std::to_string(tasks.size());
    for (const std::string& task : tasks)
    {
      job.task = ParseGridTask(task);
      for (const auto& [name, content] : this->Contents(output))
      {
        EXPECT_EQ(name.front(), '.') << task;
      }
    }
    job.task = ParseGridTask("join");
    EXPECT_TRUE(this->Contents(output) == expected) << tasks.size() << " tasks";
    EXPECT_EQ(report.files.size(), 5U);
  }
}

TEST_F(MakingTasks, TasksThatFindNothingOfOthersSayWhatIsMissing)
{
  const auto ends = [](const std::string& text, const std::string& end)
  { return text.size() > end.size() && text.substr(text.size() - end.size()) == end; };
  EXPECT_PRED2(
    ends, this->Run("rows:1/2"), "lacks what --task scan:1/N leaves there; run these tasks first");
  EXPECT_EQ(this->Run("scan:2/2"), "");
  EXPECT_PRED2(ends, this->Run("rows:1/2"), "scan-1-of-2: is missing; run --task scan:1/2 first");
  EXPECT_EQ(this->Run("scan:1/2"), "");
  EXPECT_PRED2(
    ends, this->Run("join"), "lacks what --task rows:1/N leaves there; run these tasks first");
  EXPECT_EQ(this->Run("rows:1/2"), "");
  EXPECT_PRED2(ends, this->Run("join"), "made-2-of-2: is missing; run --task rows:2/2 first");
  EXPECT_EQ(this->Run("rows:1/3"), "");
  EXPECT_PRED2(ends, this->Run("join"),
    "holds parts of different numbers of --task rows; remove the folder, and begin anew");
  EXPECT_FALSE(fs::exists(job.folder / "volumes.nxv.series"));
  // Tasks with other options share nothing with these.
  job.recipe = "another step";
  EXPECT_PRED2(
    ends, this->Run("rows:1/2"), "lacks what --task scan:1/N leaves there; run these tasks first");
}

TEST_F(MakingTasks, TasksNoticeWhatTheyCannotDivide)
{
  // A file that comes after the rows were made changes what these are made of.
  EXPECT_EQ(this->Run("scan:1/1"), "");
  EXPECT_EQ(this->Run("rows:1/1"), "");
  const Site keax = {"KEAX", Position{38.81, -94.264, 333.0}};
  this->Write("late", keax, start + 17min, 55.0);
  EXPECT_NE(this->Run("join").find("these rows were made of other files"), std::string::npos);
  EXPECT_EQ(this->Run("rows:1/1"), "");
  EXPECT_EQ(this->Run("join"), "");
  // A header that errs hides nothing from the scan, but it may hide when the run ends.
  this->Write("later", keax, start + 60min, 55.0);
  SetHeaderTime(files.back(), start + 18min);
  EXPECT_EQ(this->Run("scan:1/1"), "");
  EXPECT_EQ(this->Run("rows:1/1"),
    "some files hold other radars or times than their headers say: make "
    "these volumes without --task");
  // All files tell the biases.
  job.options.measureBiases = true;
  EXPECT_EQ(this->Run("scan:1/1"),
    "the headers do not tell which files are needed: make these volumes in one run");
  job.written.largestWhole = 1'000'000;
  EXPECT_EQ(this->Run("scan:1/1"),
    "--task divides volumes in bricks alone: merged, nxv, of more than 134 million voxels");
}

TEST(GridTasks, OtherTextsAreNone)
{
  for (const char* text : {"", "scan", "scan:", "scan:0/2", "scan:3/2", "rows:1/0", "rows:1/2/3",
         "rows:1 /2", "join:1/2", "rows:1/100000", "Rows:1/2"})
  {
    EXPECT_EQ(MessageOf([&] { ParseGridTask(text); }),
      "'" + std::string(text) +
        "' is no task; write scan:1/4 (the first of four parts), rows:1/4 or join");
  }
  const GridTask task = ParseGridTask("rows:2/3");
  EXPECT_TRUE(task.kind == GridTask::Kind::Rows && task.part == 1 && task.parts == 3);
}

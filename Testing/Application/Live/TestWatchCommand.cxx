// SPDX-License-Identifier: BSD-3-Clause
// Runs of `watch`, and what `grid` makes of the same files.
#include "Feed/ChunkMaker.h"
#include "HandMadeVolume.h"
#include "ProgramRun.h"
#include "Scans/RadarsOfMissouri.h"
#include "TestData.h"

#include <nlohmann/json.hpp>

#include <gtest/gtest.h>

#include <csignal>
#include <filesystem>
#include <fstream>
#include <map>
#include <string>
#include <vector>

using namespace nexrad;
using namespace nexrad::testing;
using namespace std::chrono_literals;
namespace fs = std::filesystem;

namespace
{

/// An hour of two radars (synthetic), in chunks and in files.
class Watches : public ::testing::Test
{
protected:
  void WriteRadar(const Site& site, Duration period, int volumes, bool inChunks) const
  {
    for (int i = 0; i < volumes; ++i)
    {
      const Time time = start + i * period;
      const fs::path path = in / site.name / std::to_string(1 + (997 + i) % 999);
      if (inChunks)
      {
        WriteChunks(path, CutIntoChunks(VolumeOfSweeps(site, time, 2, 10.0 + i)));
      }
      else
      {
        fs::create_directories(path.parent_path());
        WriteLevel2(path.parent_path() / (site.name + FormatForFileName(time)),
          {ConstantVolume(site, time, 10.0 + i)});
      }
    }
  }

  // Rays of one value are a fault of the receiver for quality control.
  std::vector<std::string> Merging() const
  {
    return {"--dims", "40x40x10", "--step", "2min", "--range", "150km", "--quality", "off"};
  }

  std::vector<std::string> Command(
    const std::vector<std::string>& more = {"--stop-after", "2s"}) const
  {
    std::vector<std::string> words = {"watch", in, "-o", out, "--no-picture"};
    const auto merging = this->Merging();
    words.insert(words.end(), merging.begin(), merging.end());
    words.insert(words.end(), more.begin(), more.end());
    return words;
  }

  static std::map<std::string, std::string> Series(const fs::path& path)
  {
    std::map<std::string, std::string> contents;
    std::error_code none;
    for (const auto& entry : fs::directory_iterator(path, none))
    {
      const std::string name = entry.path().filename();
      if (entry.is_regular_file() && name != "status.json" && name != "newest.nxv" &&
          name.front() != '.')
      {
        contents[name] = FileContent(entry.path());
      }
    }
    return contents;
  }

  // Names each file that one of them lacks, or that has other bytes.
  static void ExpectSame(const std::map<std::string, std::string>& made,
    const std::map<std::string, std::string>& expected)
  {
    for (const auto& [name, content] : expected)
    {
      EXPECT_TRUE(made.count(name) > 0 && made.at(name) == content) << name;
    }
    for (const auto& [name, content] : made)
    {
      EXPECT_EQ(expected.count(name), 1U) << name;
    }
  }

  ProgramRun Grid(const fs::path& made) const
  {
    std::vector<std::string> words = {"grid", in, "-o", made, "--quiet"};
    const auto merging = this->Merging();
    words.insert(words.end(), merging.begin(), merging.end());
    return RunNexrad3d(words);
  }

  std::map<std::string, std::string> OfGrid() const
  {
    const fs::path made = folder.Path() / "grid";
    EXPECT_NE(this->Grid(made).status, 1);
    return Series(made);
  }

  nlohmann::json Status() const { return nlohmann::json::parse(FileContent(out / "status.json")); }

  const TemporaryFolder folder;
  const fs::path in = folder.Path() / "in";
  const fs::path out = folder.Path() / "out";
};

} // namespace

TEST_F(Watches, AnHourInFilesAndChunksIsTheSeriesOfGrid)
{
  this->WriteRadar(keax, 5min, 12, true);
  this->WriteRadar(klsx, 6min, 10, false);
  const ProgramRun run = RunNexrad3d(this->Command());
  EXPECT_EQ(run.status, 0) << run.errors;
  const auto expected = this->OfGrid();
  EXPECT_GT(expected.size(), 25U);
  ExpectSame(Series(out), expected);
  EXPECT_TRUE(fs::exists(out / "newest.nxv"));
  EXPECT_FALSE(fs::exists(out / ".grid.part"));
  const nlohmann::json status = this->Status();
  EXPECT_EQ(status.at("state"), "stopped");
  EXPECT_EQ(status.at("series").at("steps"), expected.size() - 1);
  EXPECT_EQ(status.at("newest").at("time"), "2006-03-12T18:58:59.666Z");
  ASSERT_EQ(status.at("radars").size(), 2U);
  EXPECT_EQ(status["radars"][0]["radar"], "KEAX");
  EXPECT_EQ(status["radars"][0]["state"], "STALE") << "years old";
  EXPECT_EQ(status["radars"][0]["files"]["used"], 12 * 7);
  EXPECT_EQ(status["radars"][1]["files"]["used"], 10);
}

// A file without compressed records is known to be whole once it has not grown for a while. As long
// as one is waited for, the steps before its volume, with which it is merged, stay open, however
// old they are.
TEST_F(Watches, StepsBeforeAVolumeThatIsWaitedForStayOpen)
{
  this->WriteRadar(keax, 5min, 12, true);
  this->WriteRadar(klsx, 6min, 10, false);
  for (const auto& file : fs::directory_iterator(in / "KLSX"))
  {
    if (file.path().filename() < "KLSX20060312T182500Z")
    {
      fs::last_write_time(file.path(), fs::file_time_type::clock::now() - 1h);
    }
  }
  const ProgramRun run = RunNexrad3d(this->Command({"--stop-after", "4s"}));
  EXPECT_EQ(run.status, 0) << run.errors;
  ExpectSame(Series(out), this->OfGrid());
}

TEST_F(Watches, AnAgeIsLiveByTheClockOfTheData)
{
  this->WriteRadar(keax, 5min, 3, true);
  this->WriteRadar(klsx, 6min, 1, false);
  const ProgramRun run = RunNexrad3d(
    this->Command({"--replay", "2006-03-12T18:20,1", "--stale", "10min", "--stop-after", "1s"}));
  EXPECT_EQ(run.status, 0) << run.errors;
  EXPECT_NE(run.output.find("KEAX LIVE 6 min, KLSX STALE 19 min"), std::string::npos) << run.output;
  const nlohmann::json status = this->Status();
  EXPECT_EQ(status["radars"][0]["state"], "LIVE");
  EXPECT_EQ(status["radars"][1]["state"], "STALE");
}

// As kill -9 and Ctrl+C end it, again and again; what came in the meantime is used.
TEST_F(Watches, WhatWasEndedGoesOnWhereItWas)
{
  this->WriteRadar(keax, 5min, 8, true);
  this->WriteRadar(klsx, 6min, 7, true);
  std::size_t steps = 0;
  for (const int signal : {SIGTERM, SIGKILL, SIGINT, SIGKILL})
  {
    steps += 4;
    const ProgramRun run = InterruptProgram(
      Nexrad3dPath(), this->Command({}), [&] { return Series(out).size() >= steps; }, signal);
    EXPECT_EQ(run.status, signal == SIGKILL ? -1 : 0) << run.errors;
    if (signal != SIGKILL)
    {
      EXPECT_EQ(this->Status().at("state"), "stopped");
    }
    for (const auto& entry : fs::directory_iterator(out))
    {
      EXPECT_EQ(
        signal != SIGKILL && entry.path().string().find(".part-") != std::string::npos, false)
        << entry.path();
    }
  }
  this->WriteRadar(keax, 5min, 12, true);
  this->WriteRadar(klsx, 6min, 10, true);
  const ProgramRun last = RunNexrad3d(this->Command());
  EXPECT_EQ(last.status, 0) << last.errors;
  ExpectSame(Series(out), this->OfGrid());
}

TEST_F(Watches, OtherOptionsAndOtherRunsAreRefused)
{
  this->WriteRadar(keax, 5min, 4, true);
  ASSERT_EQ(RunNexrad3d(this->Command()).status, 0);
  const auto made = Series(out);
  const ProgramRun other = RunNexrad3d(
    {"watch", in, "-o", out, "--no-picture", "--dims", "20x20x10", "--stop-after", "1s"});
  EXPECT_EQ(other.status, 1);
  EXPECT_NE(other.errors.find("holds a series of other options"), std::string::npos)
    << other.errors;
  ProgramRun second;
  ProgramRun grid;
  InterruptProgram(
    Nexrad3dPath(), this->Command({}),
    [&]
    {
      if (!fs::exists(out / ".grid.part" / "lock"))
      {
        return false;
      }
      second = RunNexrad3d(this->Command());
      grid = this->Grid(out);
      return true;
    },
    SIGTERM);
  for (const ProgramRun* run : {&second, &grid})
  {
    EXPECT_EQ(run->status, 1);
    EXPECT_NE(run->errors.find("another run writes volumes into this folder"), std::string::npos)
      << run->errors;
  }
  ExpectSame(Series(out), made);
}

// While all steps may still change, a radar that comes makes the domain larger.
TEST_F(Watches, ARadarThatComesMakesTheDomainLarger)
{
  this->WriteRadar(keax, 5min, 3, true);
  ASSERT_EQ(RunNexrad3d(this->Command()).status, 0);
  this->WriteRadar(klsx, 6min, 3, true);
  ASSERT_EQ(RunNexrad3d(this->Command()).status, 0);
  ExpectSame(Series(out), this->OfGrid());
}

// Later it does not: the volumes of a series have one grid.
TEST_F(Watches, ARadarThatComesLaterLeavesTheDomain)
{
  this->WriteRadar(keax, 5min, 12, true);
  ASSERT_EQ(RunNexrad3d(this->Command()).status, 0);
  this->WriteRadar(klsx, 6min, 12, true);
  const ProgramRun run = RunNexrad3d(this->Command());
  EXPECT_EQ(run.status, 0) << run.errors;
  EXPECT_NE(run.output.find("KLSX came when the domain was settled"), std::string::npos)
    << run.output;
}

TEST_F(Watches, OldVolumesAreRemovedWhereTheyAreNotKept)
{
  this->WriteRadar(keax, 5min, 20, true);
  ASSERT_EQ(RunNexrad3d(this->Command({"--keep", "45min", "--stop-after", "2s"})).status, 0);
  const auto series = Series(out);
  EXPECT_EQ(series.count("20060312T180000Z.nxv"), 0U);
  EXPECT_EQ(series.count("20060312T193800Z.nxv"), 1U);
  EXPECT_EQ(this->Status().at("series").at("steps"), series.size() - 1);
}

TEST_F(Watches, DamageIsNamedAndTheExitStatusSaysSo)
{
  auto chunks = CutIntoChunks(VolumeOfSweeps(keax, start, 3, 20.0));
  chunks.erase(chunks.begin() + 4);
  WriteChunks(in / "KEAX" / "1", chunks);
  this->WriteRadar(klsx, 6min, 2, true);
  const ProgramRun run = RunNexrad3d(this->Command());
  EXPECT_EQ(run.status, 3);
  EXPECT_NE(run.errors.find("1 chunk missing before this one"), std::string::npos) << run.errors;
  ExpectSame(Series(out), this->OfGrid());
}

TEST_F(Watches, ARestartInTheNextFileIsNoDamage)
{
  HandMadeVolume half = ConstantVolume(keax, start, 20.0); // 3.6 s, and as much is left
  half.sweeps[0].rays = 180;
  half.sweeps[0].turn = 180.0;
  half.complete = false;
  fs::create_directories(in);
  WriteLevel2(in / "a", {half});
  WriteLevel2(in / "b", {ConstantVolume(keax, start + 4600ms, 20.0)});
  const ProgramRun run = RunNexrad3d(this->Command({"--stop-after", "1s"}));
  EXPECT_EQ(run.status, 0) << run.errors;
  EXPECT_EQ(run.errors.find("no end of volume"), std::string::npos) << run.errors;
  EXPECT_EQ(this->Status().at("problems"), 0);
}

TEST_F(Watches, AFeedWithoutARadarIsAFailure)
{
  fs::create_directories(in);
  const ProgramRun run = RunNexrad3d(this->Command({"--stop-after", "0.5s"}));
  EXPECT_EQ(run.status, 1);
  EXPECT_NE(run.errors.find("nothing arrived"), std::string::npos) << run.errors;
}

TEST_F(Watches, WrongWordsAreRefused)
{
  for (const auto& [option, value] :
    std::map<std::string, std::string>{{"--replay", "18:00"}, {"--poll", "0"}, {"--bias", "auto"}})
  {
    const ProgramRun run = RunNexrad3d({"watch", in, "-o", out, option, value});
    EXPECT_NE(run.status, 0) << option;
    EXPECT_FALSE(fs::exists(out / "newest.nxv"));
  }
}

// The sets of chunks of real radars, as the feed left them.
TEST_F(Watches, RealSetsOfChunksAreReplayed)
{
  NEXRAD_REQUIRE_TEST_DATA(data);
  for (const char* name : {"KLOT-20210729", "TORD-20260811", "KHDX-20240401-partial"})
  {
    fs::remove_all(in);
    fs::remove_all(out);
    fs::remove_all(folder.Path() / "grid");
    fs::create_directories(in);
    fs::copy(data / "level2" / "chunks" / name, in / name, fs::copy_options::recursive);
    const std::vector<std::string> words = {"watch", in, "-o", out, "--no-picture", "--dims",
      "64x64x32", "--step", "1min", "--stop-after", "3s"};
    const ProgramRun run = RunNexrad3d(words);
    EXPECT_NE(run.status, 1) << run.errors;
    const fs::path made = folder.Path() / "grid";
    const ProgramRun grid =
      RunNexrad3d({"grid", in, "-o", made, "--dims", "64x64x32", "--step", "1min", "--quiet"});
    EXPECT_EQ(run.status, grid.status) << name;
    EXPECT_GT(Series(made).size(), 1U) << name;
    EXPECT_TRUE(Series(out) == Series(made)) << name;
  }
}

// It is years older, and of a radar far away: with it the series would have a million steps.
TEST_F(Watches, AFileOfAnotherDecadeChangesNothing)
{
  this->WriteRadar(keax, 5min, 4, true);
  const auto expected = this->OfGrid();
  const std::vector<std::string> replay = {"--replay", "2006-03-12T18:20,1", "--stop-after", "2s"};
  const auto writeOld = [this]
  {
    WriteLevel2(in / "KFTG19960312_180000",
      {ConstantVolume({"KFTG", Position{39.78, -104.54, 1705.0}}, start - 87'660h, 40.0)});
  };
  writeOld();
  const ProgramRun with = RunNexrad3d(this->Command(replay));
  EXPECT_EQ(with.status, 3) << with.errors;
  EXPECT_NE(with.errors.find("KFTG19960312_180000: is of 1996-03-12T06:00:00.000Z, long before"),
    std::string::npos)
    << with.errors;
  ExpectSame(Series(out), expected);

  fs::remove_all(out);
  fs::rename(in / "KEAX", folder.Path() / "KEAX");
  const ProgramRun before = InterruptProgram(
    Nexrad3dPath(), this->Command(replay),
    [&]
    {
      const bool isMade = fs::exists(out / "19960312T060000Z.nxv");
      if (isMade && fs::exists(folder.Path() / "KEAX"))
      {
        fs::rename(folder.Path() / "KEAX", in / "KEAX");
      }
      return false;
    },
    SIGTERM);
  EXPECT_EQ(before.status, 3) << before.errors;
  EXPECT_NE(before.errors.find("KFTG19960312_180000: is of 1996"), std::string::npos)
    << before.errors;
  ExpectSame(Series(out), expected);
}

TEST_F(Watches, TheStatusOfARunThatFailsSaysWhy)
{
  this->WriteRadar(keax, 5min, 2, true);
  const auto expectStopped = [this](const ProgramRun& run, const std::string& why)
  {
    EXPECT_EQ(run.status, 1) << run.errors;
    EXPECT_EQ(this->Status().at("state"), "stopped");
    const std::string reason = this->Status().at("reason");
    EXPECT_NE(reason.find(why), std::string::npos) << reason;
    EXPECT_NE(run.errors.find(reason), std::string::npos) << run.errors;
  };
  expectStopped(RunNexrad3d(this->Command({"--bias", "auto"})), "biases cannot be measured");
  fs::create_directory(out / "newest.nxv");
  expectStopped(RunNexrad3d(this->Command()), "newest.nxv: cannot be written");
  fs::remove(out / "newest.nxv");
  ASSERT_EQ(RunNexrad3d(this->Command()).status, 0);
  EXPECT_EQ(this->Status().at("reason"), "nothing arrived for the time of --stop-after");
  expectStopped(RunNexrad3d(this->Command({"--max-gap", "3min"})), "a series of other options");
}

TEST_F(Watches, ATerminalThatClosesEndsItInOrder)
{
  this->WriteRadar(keax, 5min, 2, true);
  const ProgramRun run = InterruptProgram(
    Nexrad3dPath(), this->Command({}), [&] { return fs::exists(out / "newest.nxv"); }, SIGHUP);
  EXPECT_EQ(run.status, 0) << run.errors;
  EXPECT_EQ(this->Status().at("state"), "stopped");
  EXPECT_EQ(this->Status().at("reason"), "a signal asked for it");
}

// SPDX-License-Identifier: BSD-3-Clause
#include "nexrad/Series/Catalogue.h"

#include "ErrorMessage.h"
#include "Faults/Unprivileged.h"
#include "HandMadeVolume.h"
#include "Scans/RadarsOfMissouri.h"
#include "TestData.h"
#include "Tolerance.h"
#include "nexrad/Series/ScanInputs.h"
#include "nexrad/System/Error.h"

#include <gtest/gtest.h>

#include <sys/stat.h>

#include <filesystem>
#include <fstream>
#include <mutex>
#include <new>

namespace nexrad
{
namespace
{

namespace fs = std::filesystem;

using testing::At;
using testing::ConstantVolume;
using testing::HoldsUnprivileged;
using testing::keax;
using testing::klsx;
using testing::TemporaryFolder;
using testing::WriteLevel2;

void WriteText(const std::filesystem::path& path, const std::string& text)
{
  std::ofstream(path) << text;
}

TEST(SiteSeries, GroupsByTheSiteInTheFileAndSortsByTime)
{
  const TemporaryFolder folder;
  // The names say nothing true: neither the site nor the order.
  WriteLevel2(folder.Path() / "KLSX_a", {ConstantVolume(keax, At("2006-03-12T18:05:00Z"), 20.0)});
  WriteLevel2(folder.Path() / "KLSX_b", {ConstantVolume(keax, At("2006-03-12T18:00:00Z"), 20.0)});
  WriteLevel2(folder.Path() / "KLSX_c", {ConstantVolume(klsx, At("2006-03-12T18:02:00Z"), 20.0)});
  const auto scan = ScanInputs({folder.Path()});
  ASSERT_TRUE(scan);
  EXPECT_TRUE(scan->problems.empty());
  ASSERT_EQ(scan->sites.size(), 2U);
  EXPECT_EQ(scan->sites[0].site.name, "KEAX");
  EXPECT_EQ(scan->sites[1].site.name, "KLSX");
  ASSERT_EQ(scan->sites[0].volumes.size(), 2U);
  EXPECT_EQ(scan->sites[0].volumes[0].file.filename(), "KLSX_b");
  EXPECT_EQ(scan->sites[0].volumes[0].rays, 360U);
  EXPECT_EQ(scan->First(), At("2006-03-12T18:00:00Z"));
  EXPECT_EQ(scan->Last(), At("2006-03-12T18:05:00Z") + Duration(20 * 359));
  EXPECT_EQ(scan->Positions().size(), 2U);
}

// The rest of the day is made.
TEST(SiteSeries, AFileThatNeedsTooMuchMemoryIsLeftOut)
{
  const TemporaryFolder folder;
  WriteLevel2(folder.Path() / "a", {ConstantVolume(keax, At("2006-03-12T18:00:00Z"), 20.0)});
  WriteLevel2(folder.Path() / "b", {ConstantVolume(keax, At("2006-03-12T18:05:00Z"), 20.0)});
  const auto visitor =
    [](const SeriesVolume& volume, const RadarVolume&, const std::shared_ptr<const PolarVolume>&)
  {
    if (volume.file.filename() == "a")
    {
      throw std::bad_alloc();
    }
  };
  const auto scan = ScanInputs({folder.Path()}, {}, visitor);
  ASSERT_TRUE(scan);
  ASSERT_EQ(scan->problems.size(), 1U);
  EXPECT_EQ(scan->problems[0].Line(),
    (folder.Path() / "a").string() + ": needs more memory than there is: left out");
  ASSERT_EQ(scan->sites.size(), 1U);
  EXPECT_EQ(scan->sites[0].volumes.size(), 1U);
}

TEST(SiteSeries, SplitsAFileOfSeveralCycles)
{
  const TemporaryFolder folder;
  const Time first = At("2006-03-12T18:00:00Z");
  const Time second = At("2006-03-12T18:05:00Z");
  const auto path = WriteLevel2(
    folder.Path() / "two", {ConstantVolume(keax, first, 20.0), ConstantVolume(keax, second, 30.0)});
  const auto scan = ScanInputs({path});
  ASSERT_EQ(scan->sites.size(), 1U);
  ASSERT_EQ(scan->sites[0].volumes.size(), 2U);
  EXPECT_EQ(scan->sites[0].volumes[0].start, first);
  EXPECT_EQ(scan->sites[0].volumes[1].start, second);
  EXPECT_EQ(scan->sites[0].volumes[1].cycle, 1U);
}

TEST(SiteSeries, KeepsTheFullerOfTwoCopies)
{
  const TemporaryFolder folder;
  const Time start = At("2006-03-12T18:00:00Z");
  testing::HandMadeVolume half = ConstantVolume(keax, start, 20.0);
  half.sweeps[0].rays = 180;
  half.sweeps[0].turn = 180.0;
  WriteLevel2(folder.Path() / "a-half", {half});
  WriteLevel2(folder.Path() / "b-whole", {ConstantVolume(keax, start, 20.0)});
  const auto scan = ScanInputs({folder.Path()});
  ASSERT_EQ(scan->sites[0].volumes.size(), 1U);
  EXPECT_EQ(scan->sites[0].volumes[0].file.filename(), "b-whole");
  ASSERT_EQ(scan->problems.size(), 1U);
  EXPECT_TRUE(scan->problems[0].leftOut);
  EXPECT_NE(scan->problems[0].Line().find("a-half: the same volume as"), std::string::npos);
}

// A volume of half a turn of 3.6 s, and the next one in another file.
TEST(SiteSeries, ARestartOfTheRadarIsANote)
{
  const Time first = At("2006-03-12T18:00:00Z");
  testing::HandMadeVolume half = ConstantVolume(keax, first, 20.0);
  half.sweeps[0].rays = 180;
  half.sweeps[0].turn = 180.0;
  half.complete = false;
  for (const int pause : {1000, 3000}) // ms: less and more than half of the rest takes
  {
    const TemporaryFolder folder;
    WriteLevel2(folder.Path() / "a", {half});
    WriteLevel2(folder.Path() / "b", {ConstantVolume(keax, first + Duration(3600 + pause), 20.0)});
    const auto scan = ScanInputs({folder.Path()});
    ASSERT_TRUE(scan);
    EXPECT_EQ(scan->sites.at(0).volumes.size(), 2U);
    EXPECT_EQ(scan->problems.size(), pause < 1800 ? 0U : 1U);
    ASSERT_EQ(scan->notes.size(), pause < 1800 ? 1U : 0U);
    for (const std::string& note : scan->notes)
    {
      EXPECT_EQ(note, (folder.Path() / "a").string() +
                        ": the radar broke the volume off and began the new one of " +
                        (folder.Path() / "b").string());
    }
  }
}

// Two radars of one name, or a wrong position: the second never stands at the first's place.
TEST(SiteSeries, NamesakesFarApartAreNotMerged)
{
  const TemporaryFolder folder;
  const Site moved = {"KEAX", Position{38.82, -94.264, 340.0}}; // 1.1 km
  const Site other = {"KEAX", Position{41.0, -94.264, 333.0}};
  WriteLevel2(folder.Path() / "a", {ConstantVolume(other, At("2006-03-12T18:00:00Z"), 20.0)});
  WriteLevel2(folder.Path() / "b", {ConstantVolume(keax, At("2006-03-12T18:05:00Z"), 20.0)});
  WriteLevel2(folder.Path() / "c", {ConstantVolume(moved, At("2006-03-12T18:10:00Z"), 20.0)});
  const auto scan = ScanInputs({folder.Path()});
  ASSERT_EQ(scan->sites.size(), 1U);
  EXPECT_EQ(scan->sites[0].volumes.size(), 2U);
  EXPECT_NEAR(scan->sites[0].site.position->latitude, 38.81, 1e-4);
  ASSERT_EQ(scan->problems.size(), 1U);
  EXPECT_TRUE(scan->problems[0].leftOut);
  EXPECT_EQ(scan->problems[0].Line().find((folder.Path() / "a").string()), 0U);
  EXPECT_NE(scan->problems[0].Line().find("has a radar KEAX at 41.000, -94.264 degrees, and other "
                                          "files have it at 38.810, -94.264 degrees"),
    std::string::npos)
    << scan->problems[0].Line();
}

TEST(SiteSeries, NamesWhatIsDamagedOrLeftOut)
{
  const TemporaryFolder folder;
  const auto path =
    WriteLevel2(folder.Path() / "whole", {ConstantVolume(keax, At("2006-03-12T18:00:00Z"), 20.0)});
  // Cut off in mid-stream: the rays before the cut take part.
  std::filesystem::copy(path, folder.Path() / "cut");
  std::filesystem::resize_file(
    folder.Path() / "cut", std::filesystem::file_size(folder.Path() / "cut") - 30'000);
  WriteText(folder.Path() / "notes.txt", "nothing of interest to a radar");
  WriteText(folder.Path() / ".hidden", "passed over");
  const auto scan = ScanInputs({folder.Path() / "cut", folder.Path() / "notes.txt"});
  ASSERT_EQ(scan->sites.size(), 1U);
  EXPECT_AT_MOST(scan->sites[0].volumes[0].rays, 360U, "rays of the damaged volume");
  EXPECT_AT_LEAST(scan->sites[0].volumes[0].rays, 150U, "rays of the damaged volume");
  ASSERT_GE(scan->problems.size(), 2U);
  EXPECT_TRUE(scan->problems.front().offset);
  EXPECT_FALSE(scan->problems.front().leftOut);
  EXPECT_TRUE(scan->problems.back().leftOut);

  const InputFiles found = FindInputFiles({folder.Path()});
  EXPECT_EQ(found.paths.size(), 2U);
  ASSERT_EQ(found.problems.size(), 1U);
  EXPECT_EQ(found.problems[0].Line(),
    (folder.Path() / "notes.txt").string() + ": not a Level II file: left out");
}

// Three links in every folder lead to as many ways as a listing of all of them never ends with.
TEST(SiteSeries, LinksAndPipesInFoldersDoNotHoldUpTheSearch)
{
  const TemporaryFolder folder;
  const fs::path inner = folder.Path() / "inner";
  fs::create_directory(inner);
  WriteLevel2(inner / "whole", {ConstantVolume(keax, At("2006-03-12T18:00:00Z"), 20.0)});
  for (const char* name : {"a", "b", "c"})
  {
    fs::create_directory_symlink("..", inner / name);
    fs::create_directory_symlink("inner", folder.Path() / name);
  }
  ASSERT_EQ(mkfifo((inner / "pipe").c_str(), 0600), 0);
  const InputFiles found = FindInputFiles({folder.Path(), folder.Path()});
  EXPECT_EQ(found.paths.size(), 1U);
  ASSERT_EQ(found.problems.size(), 1U);
  EXPECT_NE(
    found.problems[0].Line().find("pipe: neither a file nor a folder: left out"), std::string::npos)
    << found.problems[0].Line();
}

TEST(SiteSeries, WhatCannotBeReadIsNamedAndTheRestIsTaken)
{
  const TemporaryFolder folder;
  fs::permissions(folder.Path(), fs::perms(0755));
  for (const char* name : {"closed", "open"})
  {
    fs::create_directory(folder.Path() / name);
    WriteLevel2(
      folder.Path() / name / "volume", {ConstantVolume(keax, At("2006-03-12T18:00:00Z"), 20.0)});
  }
  WriteLevel2(folder.Path() / "secret", {ConstantVolume(keax, At("2006-03-12T18:05:00Z"), 20.0)});
  fs::create_symlink("nowhere", folder.Path() / "dangling");
  fs::permissions(folder.Path() / "closed", fs::perms::none);
  fs::permissions(folder.Path() / "secret", fs::perms::none);
  EXPECT_TRUE(HoldsUnprivileged(
    [&folder]
    {
      const InputFiles found = FindInputFiles({folder.Path()});
      std::vector<std::string> lines;
      for (const InputProblem& problem : found.problems)
      {
        lines.push_back(fs::relative(problem.Line(), folder.Path()));
      }
      return found.paths == std::vector<fs::path>{folder.Path() / "open" / "volume"} &&
             lines == std::vector<std::string>{
                        "closed: the folder cannot be read: Permission denied: left out",
                        "dangling: No such file or directory: left out",
                        "secret: cannot be read: Permission denied: left out"};
    }));
  fs::permissions(folder.Path() / "closed", fs::perms::owner_all);
}

TEST(SiteSeries, LeavesOutVolumesThatCannotBeUsed)
{
  const TemporaryFolder folder;
  const auto path =
    WriteLevel2(folder.Path() / "whole", {ConstantVolume(keax, At("2006-03-12T18:00:00Z"), 20.0)});
  SeriesOptions options;
  options.moments = {MomentName::ZDR};
  const auto scan = ScanInputs({path}, options);
  EXPECT_TRUE(scan->sites.empty());
  EXPECT_FALSE(scan->First());
  ASSERT_EQ(scan->problems.size(), 1U);
  EXPECT_EQ(scan->problems[0].what, "no ray has ZDR: left out");
}

TEST(SiteSeries, RefusesMissingPathsAndEmptyFolders)
{
  const TemporaryFolder folder;
  const std::string error = testing::MessageOf([&] { FindInputFiles({folder.Path() / "absent"}); });
  EXPECT_EQ(error, (folder.Path() / "absent").string() + ": no such file or folder");
  EXPECT_THROW(FindInputFiles({folder.Path()}), Error);
}

TEST(SiteSeries, FindsFoldersWithinFoldersAndChunkFolders)
{
  const TemporaryFolder folder;
  std::filesystem::create_directories(folder.Path() / "2006/03");
  const Time start = At("2006-03-12T18:00:00Z");
  WriteLevel2(folder.Path() / "2006/03/file", {ConstantVolume(keax, start, 20.0)});
  std::filesystem::create_directories(folder.Path() / "chunks");
  WriteText(folder.Path() / "chunks/20210729-123848-001-S", "x");
  WriteText(folder.Path() / "chunks/20210729-123848-002-I", "x");
  EXPECT_TRUE(IsChunkFolder(folder.Path() / "chunks"));
  EXPECT_FALSE(IsChunkFolder(folder.Path() / "2006"));
  const InputFiles found = FindInputFiles({folder.Path(), folder.Path() / "2006/../2006/03/file"});
  ASSERT_EQ(found.paths.size(), 2U); // a path given twice counts once
  EXPECT_EQ(found.paths[0].filename(), "file");
  EXPECT_EQ(found.paths[1].filename(), "chunks");
}

// Real radars: their lowest cut sees to 417 km, the other low tilts to 89 km, half of all cuts to
// less than 50 km.
TEST(SiteSeries, TheRangeOfATerminalRadarIsThatOfItsLowTilts)
{
  NEXRAD_REQUIRE_TEST_DATA(data);
  for (const char* path : {"tdwr/Level2_TSTL_20220213_2357.ar2v",
         "tdwr/TDAL20191021021543V08.raw.gz", "chunks/TORD-20260811"})
  {
    EXPECT_EQ(ScanInputs({data / "level2" / path}).value().Range(), 89'000.0) << path;
  }
}

TEST(SiteSeries, StopsWhenAskedTo)
{
  const TemporaryFolder folder;
  const auto path =
    WriteLevel2(folder.Path() / "whole", {ConstantVolume(keax, At("2006-03-12T18:00:00Z"), 20.0)});
  EXPECT_FALSE(ScanInputs({path}, {}, {}, [](double) { return false; }));
}

TEST(SiteSeries, ShowsEachVolumeToTheVisitor)
{
  const TemporaryFolder folder;
  for (const int minute : {10, 11, 12, 13, 14})
  {
    const std::string text = "2006-03-12T18:" + std::to_string(minute) + ":00Z";
    WriteLevel2(
      folder.Path() / std::to_string(minute), {ConstantVolume(keax, At(text.c_str()), 20.0)});
  }
  std::mutex mutex;
  std::size_t rays = 0;
  SeriesOptions options;
  options.moments = {MomentName::REF};
  ScanInputs({folder.Path()}, options,
    [&](const SeriesVolume& key, const RadarVolume& volume,
      const std::shared_ptr<const PolarVolume>& clean)
    {
      const std::lock_guard<std::mutex> lock(mutex);
      EXPECT_EQ(key.start, volume.Start());
      EXPECT_EQ(clean->start, volume.Start());
      rays += volume.RayCount();
    });
  EXPECT_EQ(rays, 5U * 360U);
}

} // namespace
} // namespace nexrad

// SPDX-License-Identifier: BSD-3-Clause
// Runs of `grid` that are ended in the middle, and the same command again.
#include "HandMadeVolume.h"
#include "ProgramRun.h"
#include "TestData.h"

#include <gtest/gtest.h>

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <csignal>
#include <cstddef>
#include <filesystem>
#include <fstream>
#include <map>
#include <random>
#include <string>
#include <utility>
#include <vector>

using namespace nexrad;
using namespace nexrad::testing;
using namespace std::chrono_literals;
namespace fs = std::filesystem;

namespace
{

/// Forty minutes of two radars whose circles overlap (synthetic), merged every minute.
class InterruptedGrid : public ::testing::Test
{
protected:
  InterruptedGrid()
  {
    fs::create_directories(folder.Path() / "in");
    const Site keax = {"KEAX", Position{38.81, -94.264, 333.0}};
    const Site near = {"KNEA", Position{38.9, -93.4, 300.0}};
    const Time start = *ParseIso8601("2006-03-12T18:00:00Z");
    for (int i = 0; i < 8; ++i)
    {
      const std::string number = std::to_string(i);
      WriteLevel2(
        folder.Path() / "in" / ("e" + number), {ConstantVolume(keax, start + i * 5min, 10.0 + i)});
      WriteLevel2(folder.Path() / "in" / ("n" + number),
        {ConstantVolume(near, start + i * 6min + 40s, 30.0 + i)});
    }
  }

  std::vector<std::string> Command(const fs::path& output, const std::string& dimensions) const
  {
    // Rays of one value are a fault of the receiver for quality control.
    return {"grid", folder.Path() / "in", "-o", output, "--step", "1min", "--dims", dimensions,
      "--range", "150km", "--quality", "off"};
  }

  // All that stands in a folder, hidden names too; nothing where a run was killed before it made
  // it.
  static std::map<std::string, std::string> Contents(const fs::path& folder)
  {
    std::map<std::string, std::string> contents;
    if (!fs::exists(folder))
    {
      return contents;
    }
    for (const auto& entry : fs::recursive_directory_iterator(folder))
    {
      if (entry.is_regular_file())
      {
        contents[fs::relative(entry.path(), folder)] = FileContent(entry.path());
      }
    }
    return contents;
  }

  // True when a run into a folder came to its end, which is when its journal is gone; what else its
  // hidden folder holds may be left behind.
  static bool IsComplete(const fs::path& folder, const std::map<std::string, std::string>& expected)
  {
    const auto contents = Contents(folder);
    return !fs::exists(folder / ".grid.part" / "run.json") &&
           std::includes(contents.begin(), contents.end(), expected.begin(), expected.end());
  }

  // A file's entry on the disk, and when its bytes were written, ns: one that is written again
  // differs in either.
  using FileEntry = std::pair<ino_t, long long>;

  // The volumes that have their names.
  static std::map<std::string, FileEntry> Volumes(const fs::path& folder)
  {
    std::map<std::string, FileEntry> volumes;
    std::error_code none;
    for (const auto& entry : fs::directory_iterator(folder, none))
    {
      struct stat status = {};
      if (entry.path().extension() == ".nxv" && stat(entry.path().c_str(), &status) == 0)
      {
        const timespec& written = status.st_mtim;
        volumes[entry.path().filename()] = {
          status.st_ino, written.tv_sec * 1'000'000'000LL + written.tv_nsec};
      }
    }
    return volumes;
  }

  // Kills a run that writes into a folder as soon as it has written that many volumes.
  ProgramRun InterruptAt(std::size_t volumes, const fs::path& output, const std::string& dimensions,
    int signal = SIGKILL) const
  {
    return InterruptProgram(
      Nexrad3dPath(), this->Command(output, dimensions),
      [&] { return Volumes(output).size() + Volumes(output / ".grid.part").size() >= volumes; },
      signal);
  }

  const TemporaryFolder folder;
};

} // namespace

TEST_F(InterruptedGrid, TwentyKillsEndWithTheBytesOfAnUndisturbedRun)
{
  const fs::path whole = folder.Path() / "whole";
  const auto begun = std::chrono::steady_clock::now();
  ASSERT_EQ(RunNexrad3d(this->Command(whole, "80x80x20")).status, 0);
  const double undisturbed =
    std::chrono::duration<double>(std::chrono::steady_clock::now() - begun).count();
  const auto expected = Contents(whole);
  ASSERT_EQ(expected.size(), 44U) << "43 volumes and their index";

  const fs::path disturbed = folder.Path() / "disturbed";
  std::mt19937 random(16);
  std::uniform_real_distribution<double> share(0.02, 0.6);
  int kills = 0;
  std::size_t madeAgain = 0;
  std::map<std::string, FileEntry> before;
  for (int attempt = 0; kills < 20 && attempt < 60; ++attempt)
  {
    const auto end =
      std::chrono::steady_clock::now() + std::chrono::duration<double>(undisturbed * share(random));
    const ProgramRun run = InterruptProgram(
      Nexrad3dPath(), this->Command(disturbed, "80x80x20"),
      [end] { return std::chrono::steady_clock::now() >= end; }, SIGKILL);
    kills += run.status == -1 ? 1 : 0;
    const auto now = Volumes(disturbed);
    for (const auto& [name, entry] : before)
    {
      madeAgain += now.count(name) == 0 || now.at(name) != entry ? 1 : 0;
    }
    if (run.status != -1)
    {
      EXPECT_EQ(run.status, 0) << run.errors;
      EXPECT_TRUE(Contents(disturbed) == expected);
    }
    if (IsComplete(disturbed, expected))
    {
      // The same command would make all again, as over any complete folder.
      fs::remove_all(disturbed);
    }
    before = Volumes(disturbed);
  }
  EXPECT_EQ(kills, 20);
  EXPECT_EQ(madeAgain, 0U) << "volumes that were there and were made again";
  const ProgramRun last = RunNexrad3d(this->Command(disturbed, "80x80x20"));
  EXPECT_EQ(last.status, 0) << last.errors;
  EXPECT_TRUE(Contents(disturbed) == expected);
  EXPECT_FALSE(fs::exists(disturbed / ".grid.part"));
}

// The volumes that were made stay, and the second run appends all of them.
TEST_F(InterruptedGrid, OneFileOfAllTimesIsWhole)
{
  const fs::path whole = folder.Path() / "whole";
  const fs::path disturbed = folder.Path() / "disturbed";
  const auto command = [this](const fs::path& output)
  {
    std::vector<std::string> words = this->Command(output, "40x40x10");
    words.insert(words.end(), {"--format", "nc", "--one-file"});
    return words;
  };
  ASSERT_EQ(RunNexrad3d(command(whole)).status, 0);
  InterruptProgram(
    Nexrad3dPath(), command(disturbed),
    [&] { return Volumes(disturbed / ".grid.part").size() >= 9; }, SIGKILL);
  const auto made = Volumes(disturbed / ".grid.part");
  EXPECT_GE(made.size(), 9U);
  EXPECT_FALSE(fs::exists(disturbed / "volumes.nc"));
  const ProgramRun again = RunNexrad3d(command(disturbed));
  EXPECT_EQ(again.status, 0) << again.errors;
  EXPECT_TRUE(Contents(disturbed) == Contents(whole));
  EXPECT_EQ(Contents(whole).size(), 1U);
}

// Over a folder that is complete: until all new volumes are there, the old ones stay.
TEST_F(InterruptedGrid, AKilledRunOverAnotherLeavesTheOldVolumes)
{
  const fs::path output = folder.Path() / "volumes";
  ASSERT_EQ(RunNexrad3d(this->Command(output, "40x40x10")).status, 0);
  const auto old = Contents(output);
  const fs::path fresh = folder.Path() / "fresh";
  ASSERT_EQ(RunNexrad3d(this->Command(fresh, "80x80x20")).status, 0);
  const auto expected = Contents(fresh);
  for (const std::size_t written : {5U, 30U})
  {
    this->InterruptAt(old.size() + written, output, "80x80x20");
    for (const auto& [name, bytes] : old)
    {
      const std::string now = FileContent(output / name);
      EXPECT_TRUE(now == bytes || now == expected.at(name)) << name;
    }
  }
  const ProgramRun last = RunNexrad3d(this->Command(output, "80x80x20"));
  EXPECT_EQ(last.status, 0) << last.errors;
  EXPECT_TRUE(Contents(output) == expected);
}

TEST_F(InterruptedGrid, OtherOptionsOrFilesBeginAnew)
{
  const fs::path output = folder.Path() / "volumes";
  EXPECT_EQ(this->InterruptAt(3, output, "80x80x20").status, -1);
  const fs::path fresh = folder.Path() / "fresh";
  ASSERT_EQ(RunNexrad3d(this->Command(fresh, "60x60x10")).status, 0);
  ASSERT_EQ(RunNexrad3d(this->Command(output, "60x60x10")).status, 0);
  EXPECT_TRUE(Contents(output) == Contents(fresh));

  const fs::path changed = folder.Path() / "changed";
  EXPECT_EQ(this->InterruptAt(3, changed, "60x60x10").status, -1);
  WriteLevel2(
    folder.Path() / "in" / "e0", {ConstantVolume({"KEAX", Position{38.81, -94.264, 333.0}},
                                   *ParseIso8601("2006-03-12T18:00:00Z"), 25.0)});
  ASSERT_EQ(RunNexrad3d(this->Command(changed, "60x60x10")).status, 0);
  fs::remove_all(fresh);
  ASSERT_EQ(RunNexrad3d(this->Command(fresh, "60x60x10")).status, 0);
  EXPECT_TRUE(Contents(changed) == Contents(fresh));
  EXPECT_FALSE(Contents(changed) == Contents(output));
}

// One file is another one after the kill, and one is new: the volumes that neither takes part in
// stay as they were written.
TEST_F(InterruptedGrid, AfterFilesChangedTheirStepsAloneAreMadeAgain)
{
  const fs::path in = folder.Path() / "in";
  fs::rename(in / "e3", folder.Path() / "e3"); // 18:15
  const fs::path output = folder.Path() / "volumes";
  EXPECT_EQ(this->InterruptAt(36, output, "60x60x10").status, -1);
  const auto made = Volumes(output);
  ASSERT_GE(made.size(), 30U);
  fs::rename(folder.Path() / "e3", in / "e3");
  WriteLevel2(in / "e0", {ConstantVolume({"KEAX", Position{38.81, -94.264, 333.0}},
                           *ParseIso8601("2006-03-12T18:00:00Z"), 25.0)});
  const ProgramRun run = RunNexrad3d(this->Command(output, "60x60x10"));
  ASSERT_EQ(run.status, 0) << run.errors;
  const fs::path fresh = folder.Path() / "fresh";
  ASSERT_EQ(RunNexrad3d(this->Command(fresh, "60x60x10")).status, 0);
  EXPECT_TRUE(Contents(output) == Contents(fresh));
  const auto now = Volumes(output);
  for (const auto& [name, entry] : made)
  {
    const bool changed = name <= "20060312T180500Z.nxv" ||
                         (name >= "20060312T181000Z.nxv" && name <= "20060312T182000Z.nxv");
    EXPECT_EQ(now.at(name) != entry, changed) << name;
  }
}

TEST_F(InterruptedGrid, CtrlCSaysHowToGoOn)
{
  const fs::path output = folder.Path() / "volumes";
  for (const int signal : {SIGINT, SIGTERM})
  {
    const std::size_t before = Volumes(output).size();
    const ProgramRun run = this->InterruptAt(before + 1, output, "120x120x40", signal);
    EXPECT_EQ(run.status, 1);
    EXPECT_NE(run.errors.find("the same command makes the rest"), std::string::npos) << run.errors;
    EXPECT_GT(Volumes(output).size(), before);
    EXPECT_FALSE(fs::exists(output / "volumes.nxv.series"));
  }
}

// The second run does not decode what the first one read, and names its damage all the same.
TEST_F(InterruptedGrid, DamageThatTheFirstRunMetIsNamedByTheSecond)
{
  const fs::path damaged = folder.Path() / "in" / "e1";
  fs::resize_file(damaged, fs::file_size(damaged) - 1000);
  const fs::path whole = folder.Path() / "whole";
  const ProgramRun undisturbed = RunNexrad3d(this->Command(whole, "60x60x10"));
  EXPECT_EQ(undisturbed.status, 3);
  EXPECT_NE(undisturbed.errors.find(damaged.string() + ": offset "), std::string::npos)
    << undisturbed.errors;
  for (const int signal : {SIGTERM, SIGKILL})
  {
    const fs::path output = folder.Path() / ("volumes" + std::to_string(signal));
    this->InterruptAt(25, output, "60x60x10", signal);
    const ProgramRun last = RunNexrad3d(this->Command(output, "60x60x10"));
    EXPECT_EQ(last.status, 3);
    EXPECT_EQ(last.errors, undisturbed.errors);
    EXPECT_TRUE(Contents(output) == Contents(whole));
  }
}

// Volumes of two grids in one folder would look like one series.
TEST_F(InterruptedGrid, AnotherGridBesideTheVolumesOfARunIsRefused)
{
  const fs::path output = folder.Path() / "volumes";
  std::vector<std::string> later = this->Command(output, "40x40x10");
  later.insert(later.end(), {"--begin", "2006-03-12T18:20"});
  ASSERT_EQ(RunNexrad3d(later).status, 0);
  const auto before = Contents(output);
  std::vector<std::string> earlier = this->Command(output, "30x30x10");
  earlier.insert(earlier.end(), {"--end", "2006-03-12T18:10"});
  const ProgramRun refused = RunNexrad3d(earlier);
  EXPECT_EQ(refused.status, 1);
  for (const char* part : {": holds 20060312T182000Z.nxv with 40x40x10 voxels of ",
         ", and this run would add 30x30x10 voxels of ", "name another folder"})
  {
    EXPECT_NE(refused.errors.find(part), std::string::npos) << refused.errors;
  }
  EXPECT_TRUE(Contents(output) == before);
}

// "run.json" is also the name of a file with which the run keeps its recipe.
TEST_F(InterruptedGrid, FilesOfOthersStay)
{
  const fs::path output = folder.Path() / "volumes";
  fs::create_directory(output);
  for (const char* name : {"run.json", "lock", "note-0", "notes.txt"})
  {
    std::ofstream(output / name) << "mine";
  }
  EXPECT_EQ(this->InterruptAt(3, output, "80x80x20").status, -1);
  ASSERT_EQ(RunNexrad3d(this->Command(output, "80x80x20")).status, 0);
  for (const char* name : {"run.json", "lock", "note-0", "notes.txt"})
  {
    EXPECT_EQ(FileContent(output / name), "mine") << name;
  }
}

TEST_F(InterruptedGrid, TwoRunsIntoOneFolderDoNotMeet)
{
  const fs::path output = folder.Path() / "volumes";
  fs::create_directories(output / ".grid.part");
  const int lock = open((output / ".grid.part" / "lock").c_str(), O_RDWR | O_CREAT, 0600);
  ASSERT_EQ(flock(lock, LOCK_EX), 0);
  const ProgramRun run = RunNexrad3d(this->Command(output, "40x40x10"));
  EXPECT_EQ(run.status, 1);
  EXPECT_NE(run.errors.find(output.string() + ": another run writes"), std::string::npos)
    << run.errors;
  close(lock);
  EXPECT_EQ(RunNexrad3d(this->Command(output, "40x40x10")).status, 0);
}

// A folder that has the name of a volume is in the way of that volume alone.
TEST_F(InterruptedGrid, AfterAWriteThatFailsTheSameCommandMakesTheRest)
{
  const fs::path whole = folder.Path() / "whole";
  ASSERT_EQ(RunNexrad3d(this->Command(whole, "40x40x10")).status, 0);
  const fs::path output = folder.Path() / "volumes";
  const fs::path inTheWay = output / "20060312T182000Z.nxv";
  fs::create_directories(inTheWay);
  const ProgramRun failed = RunNexrad3d(this->Command(output, "40x40x10"));
  EXPECT_EQ(failed.status, 1);
  EXPECT_NE(failed.errors.find(inTheWay.string() + ": cannot be written"), std::string::npos)
    << failed.errors;
  const auto made = Volumes(output);
  EXPECT_FALSE(made.empty());
  fs::remove(inTheWay);
  ASSERT_EQ(RunNexrad3d(this->Command(output, "40x40x10")).status, 0);
  EXPECT_TRUE(Contents(output) == Contents(whole));
  const auto now = Volumes(output);
  for (const auto& [name, entry] : made)
  {
    EXPECT_TRUE(name == inTheWay.filename() || now.at(name) == entry) << name << " is made again";
  }
}

// A run keeps its notes in a folder of that name, and removes them.
TEST_F(InterruptedGrid, AFolderOfOthersStays)
{
  const fs::path output = folder.Path() / "volumes";
  const fs::path theirs = output / ".grid.part";
  fs::create_directories(theirs / "photographs");
  std::ofstream(theirs / "letter.txt") << "mine";
  std::ofstream(theirs / "photographs" / "cat") << "mine";
  const ProgramRun refused = RunNexrad3d(this->Command(output, "40x40x10"));
  EXPECT_EQ(refused.status, 1);
  EXPECT_NE(refused.errors.find(theirs.string() + ": is not of a run of grid"), std::string::npos)
    << refused.errors;
  EXPECT_EQ(FileContent(theirs / "letter.txt"), "mine");
  // A folder in that of an interrupted run.
  const fs::path other = folder.Path() / "other";
  EXPECT_EQ(this->InterruptAt(3, other, "80x80x20").status, -1);
  fs::create_directories(other / ".grid.part" / "photographs");
  std::ofstream(other / ".grid.part" / "photographs" / "cat") << "mine";
  ASSERT_EQ(RunNexrad3d(this->Command(other, "80x80x20")).status, 0);
  EXPECT_EQ(Contents(other / ".grid.part"),
    (std::map<std::string, std::string>{{"photographs/cat", "mine"}}));
}

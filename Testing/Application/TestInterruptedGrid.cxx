// SPDX-License-Identifier: BSD-3-Clause
// Runs of `grid` that are ended in the middle, and the same command again.
#include "HandMadeVolume.h"
#include "ProgramRun.h"
#include "TestData.h"
#include "Tolerance.h"

#include <gtest/gtest.h>

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <csignal>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <map>
#include <random>
#include <string>
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
    return {"grid", folder.Path() / "in", "-o", output, "--step", "1min", "--dims", dimensions,
      "--range", "150km"};
  }

  // All that stands in a folder, hidden names too.
  static std::map<std::string, std::string> Contents(const fs::path& folder)
  {
    std::map<std::string, std::string> contents;
    for (const auto& entry : fs::recursive_directory_iterator(folder))
    {
      if (entry.is_regular_file())
      {
        contents[fs::relative(entry.path(), folder)] = FileContent(entry.path());
      }
    }
    return contents;
  }

  // The volumes that have their names, and the number of the disk's entry of each: a file that is
  // written again gets another.
  static std::map<std::string, ino_t> Volumes(const fs::path& folder)
  {
    std::map<std::string, ino_t> volumes;
    std::error_code none;
    for (const auto& entry : fs::directory_iterator(folder, none))
    {
      struct stat status = {};
      if (entry.path().extension() == ".nxv" && stat(entry.path().c_str(), &status) == 0)
      {
        volumes[entry.path().filename()] = status.st_ino;
      }
    }
    return volumes;
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
    std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - begun).count();
  const auto expected = Contents(whole);
  ASSERT_EQ(expected.size(), 44U) << "43 volumes and their index";

  const fs::path disturbed = folder.Path() / "disturbed";
  std::mt19937 random(16);
  std::uniform_real_distribution<double> share(0.02, 0.6);
  int kills = 0;
  std::size_t madeAgain = 0;
  std::map<std::string, ino_t> before;
  for (int attempt = 0; attempt < 20; ++attempt)
  {
    const auto after = std::chrono::milliseconds(std::int64_t(undisturbed * share(random)));
    const ProgramRun run =
      InterruptProgram(Nexrad3dPath(), this->Command(disturbed, "80x80x20"), after, SIGKILL);
    kills += run.status == -1 ? 1 : 0;
    const auto now = Volumes(disturbed);
    for (const auto& [name, entry] : before)
    {
      madeAgain += now.count(name) == 0 || now.at(name) != entry ? 1 : 0;
    }
    if (run.status != -1) // it came to its end: begin once more, with nothing there
    {
      EXPECT_EQ(run.status, 0) << run.errors;
      EXPECT_TRUE(Contents(disturbed) == expected);
      fs::remove_all(disturbed);
    }
    before = Volumes(disturbed);
  }
  EXPECT_AT_LEAST(kills, 10, "runs that were killed");
  EXPECT_EQ(madeAgain, 0U) << "volumes that were there and were made again";
  const ProgramRun last = RunNexrad3d(this->Command(disturbed, "80x80x20"));
  EXPECT_EQ(last.status, 0) << last.errors;
  EXPECT_TRUE(Contents(disturbed) == expected);
  EXPECT_FALSE(fs::exists(disturbed / ".grid.part"));
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
  for (const auto after : {150ms, 300ms})
  {
    InterruptProgram(Nexrad3dPath(), this->Command(output, "80x80x20"), after, SIGKILL);
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
  InterruptProgram(Nexrad3dPath(), this->Command(output, "80x80x20"), 200ms, SIGKILL);
  const fs::path fresh = folder.Path() / "fresh";
  ASSERT_EQ(RunNexrad3d(this->Command(fresh, "60x60x10")).status, 0);
  ASSERT_EQ(RunNexrad3d(this->Command(output, "60x60x10")).status, 0);
  EXPECT_TRUE(Contents(output) == Contents(fresh));
}

TEST_F(InterruptedGrid, CtrlCSaysHowToGoOn)
{
  const fs::path output = folder.Path() / "volumes";
  for (const int signal : {SIGINT, SIGTERM})
  {
    const ProgramRun run =
      InterruptProgram(Nexrad3dPath(), this->Command(output, "120x120x40"), 400ms, signal);
    EXPECT_EQ(run.status, 1);
    EXPECT_NE(run.errors.find("the same command"), std::string::npos) << run.errors;
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

// SPDX-License-Identifier: BSD-3-Clause
// What the program takes of the machine: the memory that it estimates beforehand, and the threads
// that it is given.
#include "ProgramRun.h"
#include "TestData.h"
#include "Tolerance.h"
#include "Volumes/VolumeFiles.h"
#include "nexrad/Merging/MemoryNeed.h"
#include "nexrad/Series/InputFiles.h"
#include "vtkNexradThreads.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <csignal>
#include <filesystem>
#include <fstream>
#include <memory>
#include <string>
#include <unistd.h>
#include <vector>

using namespace nexrad;
using namespace nexrad::application;
using namespace nexrad::testing;
namespace fs = std::filesystem;

namespace
{

using Words = std::vector<std::string>;

Words Joined(Words first, const Words& second)
{
  first.insert(first.end(), second.begin(), second.end());
  return first;
}

std::string StatusLine(const fs::path& process, const std::string& name)
{
  std::ifstream status(process / "status");
  for (std::string line; std::getline(status, line);)
  {
    if (line.rfind(name + ":", 0) == 0)
    {
      return line.substr(name.size() + 1);
    }
  }
  return "0";
}

// Threads that the program runs which this process started; 0 when none runs.
int ThreadsOfProgram()
{
  int threads = 0;
  for (const auto& entry : fs::directory_iterator("/proc"))
  {
    const std::string name = entry.path().filename();
    if (name.find_first_not_of("0123456789") == std::string::npos &&
        std::stoi(StatusLine(entry.path(), "PPid")) == getpid())
    {
      threads = std::max(threads, std::stoi(StatusLine(entry.path(), "Threads")));
    }
  }
  return threads;
}

} // namespace

// Half an hour of three radars (SYNTHETIC), simulated once.
class MemoryAndThreads : public ::testing::Test
{
protected:
  static void SetUpTestSuite()
  {
    folder = std::make_unique<TemporaryFolder>();
    ASSERT_EQ(
      RunNexrad3d({"simulate", folder->Path() / "files", "--hours", "0.5", "--quiet"}).status, 0);
  }
  static void TearDownTestSuite() { folder.reset(); }

  static Words Grid(const Words& options)
  {
    return Joined(
      {"grid", folder->Path() / "files", "-o", folder->Path() / "volumes", "--quiet"}, options);
  }

  // The need that is estimated, in parts of which the program took 0.5 to 1.
  static void ExpectEstimate(MergeOptions options, const VolumeFiles& written, const Words& words)
  {
    options.beam.codes = AreCodes(written, options);
    const InputFiles found = FindInputFiles({folder->Path() / "files"});
    const MemoryNeed need = RequireMemory(options, SizesOf(found.paths, 3), vtkNexradThreadCount(),
      UseOfWriting(written, options), KnownPlaces(ListByHeaders(found.paths)));
    const auto& size = options.grid.dimensions;
    const std::string dims =
      std::to_string(size[0]) + "x" + std::to_string(size[1]) + "x" + std::to_string(size[2]);
    const ProgramRun run = RunNexrad3d(Grid(Joined(words, {"--dims", dims, "--step", "15min"})));
    ASSERT_EQ(run.status, 0) << run.errors;
    const double part = static_cast<double>(run.peakMemory) / static_cast<double>(need.Total());
    EXPECT_AT_MOST(part, 1.0, "peak of the memory of grid, part of what was estimated");
    EXPECT_AT_LEAST(part, 0.5, "peak of the memory of grid, part of what was estimated");
  }

  static std::unique_ptr<TemporaryFolder> folder;
};

std::unique_ptr<TemporaryFolder> MemoryAndThreads::folder;

TEST_F(MemoryAndThreads, SmallGridsTakeWhatIsEstimated)
{
  MergeOptions options;
  options.grid.dimensions = {64, 64, 32};
  ExpectEstimate(options, {}, {});
}

TEST_F(MemoryAndThreads, LargeGridsTakeWhatIsEstimated)
{
  MergeOptions options;
  options.grid.dimensions = {512, 512, 128};
  ExpectEstimate(options, {}, {});
}

TEST_F(MemoryAndThreads, AncillaryArraysAndMomentsTakeWhatIsEstimated)
{
  MergeOptions options;
  options.grid.dimensions = {320, 320, 128};
  options.moments = {MomentName::REF, MomentName::VEL};
  options.beam.ancillary = true;
  ExpectEstimate(options, {}, {"--moment", "REF,VEL", "--ancillary"});
}

TEST_F(MemoryAndThreads, NetCDFTakesWhatIsEstimated)
{
  MergeOptions options;
  options.grid.dimensions = {256, 256, 64};
  VolumeFiles written;
  written.format = VolumeFormat::NetCDF;
  ExpectEstimate(options, written, {"--format", "nc"});
}

TEST_F(MemoryAndThreads, TheMethodOfTheThesisTakesWhatIsEstimated)
{
  MergeOptions options;
  options.grid.dimensions = {400, 400, 128};
  options.method = MergeMethod::Thesis;
  ExpectEstimate(options, {}, {"--method", "thesis"});
}

// As a whole the volume would take 680 MB more.
TEST_F(MemoryAndThreads, VolumesInBricksTakeWhatIsEstimated)
{
  MergeOptions options;
  options.grid.dimensions = {1024, 1024, 130};
  ExpectEstimate(options, {}, {});
}

// The run ends before it makes its folder. NetCDF needs the whole volume.
TEST_F(MemoryAndThreads, AGridThatCannotFitIsRefused)
{
  const fs::path output = folder->Path() / "none";
  const ProgramRun run = RunNexrad3d({"grid", folder->Path() / "files", "-o", output, "--dims",
    "2048x2048x500", "--memory", "1GiB", "--format", "nc"});
  EXPECT_EQ(run.status, 1);
  EXPECT_EQ(run.output, "");
  EXPECT_NE(
    run.errors.find("nexrad3d grid: a grid of 2048x2048x500 voxels needs 3"), std::string::npos)
    << run.errors;
  EXPECT_NE(run.errors.find("--memory allows 1.0 GiB; --dims "), std::string::npos) << run.errors;
  EXPECT_FALSE(fs::exists(output));
}

TEST_F(MemoryAndThreads, WhatIsSaidToFitFits)
{
  // No more voxels than a volume that is made as a whole may have.
  const ProgramRun refused = RunNexrad3d(Grid({"--dims", "1024x512x256", "--memory", "450MiB"}));
  ASSERT_EQ(refused.status, 1);
  const std::size_t begin = refused.errors.find("--dims ") + 7;
  const std::string dims = refused.errors.substr(begin, refused.errors.find(' ', begin) - begin);
  const ProgramRun run =
    RunNexrad3d(Grid({"--dims", dims, "--memory", "450MiB", "--step", "15min"}));
  EXPECT_EQ(run.status, 0) << run.errors;
  EXPECT_AT_MOST(static_cast<double>(run.peakMemory) / (450.0 * 1024.0 * 1024.0), 1.0,
    "peak of the memory of grid, part of its limit");
}

TEST_F(MemoryAndThreads, MemoryAndThreadsChangeNoVolume)
{
  const fs::path volume = folder->Path() / "volumes" / "20060312T181500Z.nxv";
  ASSERT_EQ(RunNexrad3d(Grid({"--dims", "48x48x16"})).status, 0);
  const std::string before = FileContent(volume);
  ASSERT_EQ(
    RunNexrad3d(Grid({"--dims", "48x48x16", "--threads", "1", "--memory", "512MiB"})).status, 0);
  EXPECT_EQ(FileContent(volume), before);
}

// Those that decode, those that merge with the first one among them, and one that writes.
TEST_F(MemoryAndThreads, ThreadsAreAsManyAsAsked)
{
  int most = 0;
  const auto count = [&most]
  {
    most = std::max(most, ThreadsOfProgram());
    return false; // it ends by itself
  };
  const ProgramRun run = InterruptProgram(
    Nexrad3dPath(), Grid({"--dims", "128x128x64", "--threads", "1"}), count, SIGKILL);
  ASSERT_EQ(run.status, 0) << run.errors;
  EXPECT_LE(most, 3);
  EXPECT_GE(most, 2);
}

TEST_F(MemoryAndThreads, WrongNumbersAreRefused)
{
  for (const char* number : {"0", "-1", "1.5", "many", "1025", "1,2"})
  {
    const ProgramRun run = RunNexrad3d(Grid({"--threads", number}));
    EXPECT_EQ(run.status, 2) << number;
    EXPECT_NE(run.errors.find("whole number from 1 to 1024"), std::string::npos) << run.errors;
  }
  const ProgramRun run = RunNexrad3d(Grid({"--memory", "0"}));
  EXPECT_EQ(run.status, 2);
  EXPECT_NE(run.errors.find("no memory to work with"), std::string::npos) << run.errors;
}

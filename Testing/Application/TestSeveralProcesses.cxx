// SPDX-License-Identifier: BSD-3-Clause
#include "ProgramRun.h"
#include "TestData.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <iterator>
#include <map>
#include <string>
#include <system_error>
#include <vector>

using namespace nexrad::testing;
namespace fs = std::filesystem;

namespace
{

// A test for each number of processes that mpiexec can start; without MPI there is nothing to test.
class SeveralProcesses : public ::testing::Test
{
protected:
  void SetUp() override
  {
    if (std::string(NEXRAD_MPIEXEC).empty())
    {
      GTEST_SKIP() << "mpiexec was not found, or VTK was built without MPI";
    }
    // Open MPI asks for this before it runs as root, or more processes than there are cores.
    setenv("OMPI_ALLOW_RUN_AS_ROOT", "1", 1);
    setenv("OMPI_ALLOW_RUN_AS_ROOT_CONFIRM", "1", 1);
    setenv("OMPI_MCA_rmaps_base_oversubscribe", "1", 1);
    setenv("PRTE_MCA_rmaps_default_mapping_policy", ":oversubscribe", 1); // Open MPI 5
  }

  static ProgramRun RunGrid(int processes, const std::vector<std::string>& arguments)
  {
    std::vector<std::string> words = {"-n", std::to_string(processes), Nexrad3dPath(), "grid"};
    words.insert(words.end(), arguments.begin(), arguments.end());
    return RunProgram(NEXRAD_MPIEXEC, words);
  }
};

// Names and bytes of all files in a folder.
std::map<std::string, std::string> ContentOf(const fs::path& folder)
{
  std::map<std::string, std::string> content;
  for (const auto& entry : fs::directory_iterator(folder))
  {
    content[entry.path().filename()] = FileContent(entry.path());
  }
  return content;
}

int CountOf(const std::string& part, const std::string& text)
{
  int count = 0;
  for (std::size_t place = text.find(part); place != std::string::npos;
       place = text.find(part, place + 1))
  {
    ++count;
  }
  return count;
}

} // namespace

TEST_F(SeveralProcesses, MakeTheSameFilesAsOne)
{
  NEXRAD_REQUIRE_TEST_DATA(data);
  const TemporaryFolder folder;
  const auto arguments = [&](const std::string& output)
  {
    return std::vector<std::string>{
      data / "level2" / "run-kbgm-20050821", "-o", folder.Path() / output, "--dims", "48x48x24"};
  };
  std::vector<std::string> alone = arguments("alone");
  alone.insert(alone.begin(), "grid");
  const ProgramRun one = RunNexrad3d(alone);
  ASSERT_EQ(one.status, 0);
  const auto takenOut = [](const std::string& output)
  { return output.substr(std::min(output.find("quality control"), output.size())); };
  const auto expected = ContentOf(folder.Path() / "alone");
  ASSERT_EQ(expected.size(), 7U); // six times and the index
  // Six times for four processes are not the same for each; nine have some without any.
  for (const int processes : {2, 4, 9})
  {
    const std::string output = "by-" + std::to_string(processes);
    const ProgramRun run = RunGrid(processes, arguments(output));
    EXPECT_EQ(run.status, 0) << run.errors;
    EXPECT_EQ(CountOf("6 volumes, ", run.output), 1) << run.output;
    EXPECT_EQ(CountOf("\n", run.output), 2) << run.output;
    EXPECT_EQ(takenOut(run.output), takenOut(one.output)) << "files that two processes decode";
    EXPECT_TRUE(ContentOf(folder.Path() / output) == expected) << processes << " processes";
  }
}

// A volume of more than 134 million voxels, of which the radar sees few, is made by all processes
// together; the rows of the second one it does not reach.
TEST_F(SeveralProcesses, MakeALargeVolumeTogether)
{
  NEXRAD_REQUIRE_TEST_DATA(data);
  const TemporaryFolder folder;
  const auto arguments = [&](const std::string& output)
  {
    return std::vector<std::string>{data / "level2" / "run-kbgm-20050821", "-o",
      folder.Path() / output, "--dims", "4100x4100x8", "--axes", "geographic",
      "--bounds=-90,25,-52,70", "--begin", "2005-08-21T02:55", "--end", "2005-08-21T02:55"};
  };
  std::vector<std::string> alone = arguments("alone");
  alone.insert(alone.begin(), "grid");
  ASSERT_EQ(RunNexrad3d(alone).status, 0);
  const ProgramRun run = RunGrid(2, arguments("by-2"));
  EXPECT_EQ(run.status, 0) << run.errors;
  EXPECT_EQ(CountOf("1 volume, ", run.output), 1) << run.output;
  EXPECT_TRUE(ContentOf(folder.Path() / "by-2") == ContentOf(folder.Path() / "alone"));
}

// Each process compares what all of them decoded, whether biases are taken off or not.
TEST_F(SeveralProcesses, CompareTheRadarsAsOneDoes)
{
  NEXRAD_REQUIRE_TEST_DATA(data);
  const TemporaryFolder folder;
  for (const char* bias : {"off", "auto"})
  {
    const std::string outputs[] = {"alone-" + std::string(bias), "by-2-" + std::string(bias)};
    const auto arguments = [&](const std::string& output)
    {
      return std::vector<std::string>{data / "level2" / "multisite-20100911", "-o",
        folder.Path() / output, "--dims", "48x48x12", "--bias", bias};
    };
    std::vector<std::string> words = arguments(outputs[0]);
    words.insert(words.begin(), "grid");
    const ProgramRun alone = RunNexrad3d(words);
    ASSERT_EQ(alone.status, 0) << alone.errors;
    EXPECT_EQ(CountOf("KBGM - KTYX: median ", alone.output), 1) << alone.output;
    EXPECT_EQ(CountOf("taken off", alone.output), bias == std::string("auto") ? 2 : 0);
    const ProgramRun both = RunGrid(2, arguments(outputs[1]));
    EXPECT_EQ(both.status, 0) << both.errors;
    // The first line has the folder.
    EXPECT_EQ(
      both.output.substr(both.output.find('\n')), alone.output.substr(alone.output.find('\n')));
    EXPECT_TRUE(ContentOf(folder.Path() / outputs[0]) == ContentOf(folder.Path() / outputs[1]));
  }
}

TEST_F(SeveralProcesses, DamageIsNamedOnce)
{
  NEXRAD_REQUIRE_TEST_DATA(data);
  const TemporaryFolder folder;
  const ProgramRun run = RunGrid(2, {data / "level2" / "damaged" / "KILN20080107_173809.gz", "-o",
                                      folder.Path() / "v", "--dims", "8x8x8", "--step", "5s"});
  EXPECT_EQ(run.status, 3) << run.errors;
  EXPECT_EQ(CountOf("no end of volume", run.errors), 1) << run.errors;
}

TEST_F(SeveralProcesses, AFailureInOneFailsAll)
{
  NEXRAD_REQUIRE_TEST_DATA(data);
  const TemporaryFolder folder;
  // A folder stands where the last process has to write a file.
  fs::create_directories(folder.Path() / "v" / "20050821T031000Z.nxv" / "in the way");
  const ProgramRun run = RunGrid(
    3, {data / "level2" / "run-kbgm-20050821", "-o", folder.Path() / "v", "--dims", "16x16x8"});
  EXPECT_EQ(run.status, 1);
  EXPECT_EQ(CountOf("20050821T031000Z.nxv: cannot be written", run.errors), 1) << run.errors;
  EXPECT_FALSE(fs::exists(folder.Path() / "v" / "volumes.nxv.series"));
}

// What one process cannot do before it decodes its part, the others must hear of: they would wait
// for it for ever.
TEST_F(SeveralProcesses, AFailureOfOneBeforeTheFilesAreReadFailsAll)
{
  NEXRAD_REQUIRE_TEST_DATA(data);
  const TemporaryFolder folder;
  const std::string good = data / "level2" / "run-kbgm-20050821";
  const auto runWith = [&](const std::string& input, const std::vector<std::string>& options)
  {
    std::vector<std::string> words = {"-n", "2", Nexrad3dPath(), "grid", good, "-o",
      folder.Path() / "v", "--dims", "8x8x8", ":", "-n", "1", Nexrad3dPath(), "grid", input, "-o",
      folder.Path() / "v", "--dims", "8x8x8"};
    words.insert(words.end(), options.begin(), options.end());
    return RunProgram(NEXRAD_MPIEXEC, words);
  };
  const ProgramRun options = runWith(good, {"--end", "2000-01-01"});
  EXPECT_EQ(options.status, 1);
  EXPECT_EQ(CountOf("lies before the first", options.errors), 1) << options.errors;
  const ProgramRun missing = runWith("/nonexistent", {});
  EXPECT_EQ(missing.status, 1);
  EXPECT_EQ(CountOf("/nonexistent: no such file or folder", missing.errors), 1) << missing.errors;
  const ProgramRun others = runWith(data / "level2" / "pairs", {});
  EXPECT_EQ(others.status, 1);
  EXPECT_EQ(CountOf("do not find the same input files", others.errors), 1) << others.errors;
  EXPECT_FALSE(fs::exists(folder.Path() / "v"));
}

TEST_F(SeveralProcesses, WhatIsWrongForAllIsSaidOnce)
{
  const ProgramRun missing = RunGrid(3, {"/nonexistent", "-o", "/nonexistent-too"});
  EXPECT_EQ(missing.status, 1);
  EXPECT_EQ(CountOf("no such file or folder", missing.errors), 1) << missing.errors;
  const ProgramRun usage = RunGrid(3, {"/nonexistent", "-o", "/nonexistent-too", "--dims", "x"});
  EXPECT_EQ(usage.status, 2);
  EXPECT_EQ(CountOf("'x' is no size of a grid", usage.errors), 1) << usage.errors;
}

// One process is killed in the middle of the run; one process alone makes the rest.
TEST_F(SeveralProcesses, AfterADeathTheSameCommandMakesTheRest)
{
  NEXRAD_REQUIRE_TEST_DATA(data);
  const TemporaryFolder folder;
  const auto arguments = [&](const std::string& output)
  {
    return std::vector<std::string>{"grid", data / "level2" / "run-kbgm-20050821", "-o",
      folder.Path() / output, "--dims", "64x64x24", "--step", "20s"};
  };
  ASSERT_EQ(RunNexrad3d(arguments("alone")).status, 0);
  const auto expected = ContentOf(folder.Path() / "alone");
  const fs::path output = folder.Path() / "volumes";
  const fs::path numbers = folder.Path() / "process-";
  const std::string command =
    "echo $$ > " + numbers.string() + "$OMPI_COMM_WORLD_RANK; exec \"$0\" \"$@\"";
  std::vector<std::string> words = {"-n", "2", "/bin/sh", "-c", command, Nexrad3dPath()};
  const std::vector<std::string> own = arguments("volumes");
  words.insert(words.end(), own.begin(), own.end());
  bool killed = false;
  const auto killSecond = [&]
  {
    const std::string second = FileContent(numbers.string() + "1");
    std::error_code none;
    const auto entries = std::distance(fs::directory_iterator(output, none), {});
    if (!killed && !second.empty() && entries > 3)
    {
      killed = kill(std::stoi(second), SIGKILL) == 0;
    }
    return false; // mpiexec itself gets no signal
  };
  const ProgramRun run = InterruptProgram(NEXRAD_MPIEXEC, words, killSecond, SIGTERM);
  EXPECT_TRUE(killed);
  EXPECT_NE(run.status, 0);
  EXPECT_FALSE(fs::exists(output / "volumes.nxv.series"));
  const ProgramRun rest = RunNexrad3d(own);
  EXPECT_EQ(rest.status, 0) << rest.errors;
  EXPECT_TRUE(ContentOf(output) == expected);
}

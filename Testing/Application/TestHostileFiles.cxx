// SPDX-License-Identifier: BSD-3-Clause
// The program with files that were made to do harm, within a limit of memory. The folder is beside
// the real files (NEXRAD_TEST_DATA/hostile); TestHostileBytes makes the like of them in code.
#include "ErrorMessage.h"
#include "Faults/HostileFiles.h"
#include "Filters/Series/VolumeFiles.h"
#include "ProgramRun.h"
#include "TestData.h"
#include "Tolerance.h"

#include <gtest/gtest.h>
#include <vtkImageData.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <set>
#include <string>
#include <sys/resource.h>
#include <vector>

using namespace nexrad::testing;
namespace fs = std::filesystem;

namespace
{

// As long as this lives, programs that are started get no more memory than this.
class MemoryLimit
{
public:
  explicit MemoryLimit([[maybe_unused]] rlim_t bytes)
  {
    getrlimit(RLIMIT_AS, &before);
#ifndef __SANITIZE_ADDRESS__ // which reserves terabytes of addresses
    const rlimit limit = {bytes, before.rlim_max};
    setrlimit(RLIMIT_AS, &limit);
#endif
  }
  ~MemoryLimit()
  {
    setrlimit(RLIMIT_AS, &before);
  }
  MemoryLimit(const MemoryLimit&) = delete;
  MemoryLimit& operator=(const MemoryLimit&) = delete;

private:
  rlimit before{};
};

// Ended by itself, and named no more than the thousand faults that a file's list holds.
void ExpectOrderly(const ProgramRun& run, const fs::path& file)
{
  EXPECT_TRUE(run.status == 0 || run.status == 1 || run.status == 3)
    << file << ": " << run.status << ' ' << run.errors.substr(0, 500);
  EXPECT_EQ(run.errors.find("bad_alloc"), std::string::npos) << file;
  EXPECT_LT(std::count(run.errors.begin(), run.errors.end(), '\n'), 1'010) << file;
  EXPECT_LT(run.output.size(), 800U) << file;
}

} // namespace

class HostileFiles : public testing::Test
{
protected:
  void SetUp() override
  {
    NEXRAD_REQUIRE_TEST_DATA(realFiles);
    data = realFiles;
    if (!fs::exists(data / "hostile"))
    {
      GTEST_SKIP() << "no folder hostile beside the real files";
    }
    for (const auto& entry : fs::directory_iterator(data / "hostile"))
    {
      const std::string extension = entry.path().extension();
      if (extension == ".nxv")
      {
        volumes.insert(entry.path());
      }
      else if (extension != ".md")
      {
        radarFiles.insert(entry.path());
      }
    }
  }

  fs::path data;
  std::set<fs::path> radarFiles;
  std::set<fs::path> volumes;

private:
  const MemoryLimit limit{rlim_t(3) << 30};
};

TEST_F(HostileFiles, InfoSaysWhatIsWrong)
{
  radarFiles.insert(data / "reports" / "faults" / "vheaders-mutated.gz");
  for (const fs::path& file : radarFiles)
  {
    const ProgramRun run = RunNexrad3d({"info", "--echo", file});
    ExpectOrderly(run, file);
    EXPECT_AT_MOST(
      static_cast<double>(run.peakMemory) / 1e6, 100.0, "memory of info of a hostile file, MB");
  }
}

// TestDecodingCosts decodes all of these.
TEST(MadeHostileFiles, GridKeepsToItsMemory)
{
  const std::set<std::string> tried = {"zeros", "zeros-bzip2", "volume-headers", "records-of-zeros",
    "cycle-a-ray-of-all-moments", "geometry-a-ray", "shared-gates-65000", "wide-rays",
    "a-wide-ray-a-sweep"};
  std::size_t found = 0;
  for (const HostileFile& file : MakeHostileFiles())
  {
    if (tried.count(file.name) == 0)
    {
      continue;
    }
    ++found;
    const TemporaryFolder folder;
    const Bytes stored = file.make();
    std::vector<std::string> arguments = {"grid"};
    for (const char* name : {"a.gz", "b.gz", "c.gz", "d.gz"})
    {
      arguments.push_back(folder.Path() / name);
      std::ofstream(arguments.back(), std::ios::binary)
        .write(reinterpret_cast<const char*>(stored.data()),
          static_cast<std::streamsize>(stored.size()));
    }
    for (const char* argument : {"-o", "", "--memory", "200MiB", "--dims", "32x32x8"})
    {
      arguments.emplace_back(argument);
    }
    arguments[6] = folder.Path() / "v";
    const ProgramRun run = RunNexrad3d(arguments);
    EXPECT_TRUE(run.status == 0 || run.status == 1 || run.status == 3) << file.name << run.errors;
    EXPECT_AT_MOST(static_cast<double>(run.peakMemory) / (1 << 20), 160.0,
      "memory of grid --memory 200MiB of four hostile files, MiB");
  }
  EXPECT_EQ(found, tried.size());
}

// Each beside five volumes of a real radar: the rest of the day is made.
TEST_F(HostileFiles, TheRestOfTheDayIsMade)
{
  for (const fs::path& file : radarFiles)
  {
    const TemporaryFolder folder;
    const ProgramRun run =
      RunNexrad3d({"grid", file, data / "level2" / "run-kbgm-20050821", "-o", folder.Path() / "v",
        "--dims", "32x32x8", "--begin", "2005-08-21T02:45", "--end", "2005-08-21T02:50"});
    ExpectOrderly(run, file);
    EXPECT_TRUE(fs::exists(folder.Path() / "v" / "20050821T025000Z.nxv")) << file << run.errors;
  }
}

TEST_F(HostileFiles, AMergeAtTheirOwnTimeDoesNotCrash)
{
  for (const fs::path& file : radarFiles)
  {
    const TemporaryFolder folder;
    ExpectOrderly(RunNexrad3d({"grid", file, "-o", folder.Path() / "v", "--dims", "32x32x8",
                    "--begin", "2019-10-02T08:15", "--end", "2019-10-02T08:15"}),
      file);
  }
}

TEST_F(HostileFiles, VolumesAreRefusedWithOneLine)
{
  for (const fs::path& file : volumes)
  {
    const std::string line = MessageOf([&] { nexrad::OpenVolumeFiles({file})->Load(0, {}); });
    EXPECT_EQ(line.find(file), 0U) << line;
    EXPECT_LT(line.size(), file.string().size() + 160U) << file;
  }
}

// SPDX-License-Identifier: BSD-3-Clause
// The program with files that were made to do harm, within a limit of memory. The folder is beside
// the real files (NEXRAD_TEST_DATA/hostile); TestHostileBytes makes the like of them in code.
#include "Model/Error.h"
#include "ProgramRun.h"
#include "TestData.h"
#include "Volumes/VolumeSeries.h"

#include <gtest/gtest.h>
#include <vtkImageData.h>

#include <filesystem>
#include <set>
#include <string>
#include <sys/resource.h>

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

std::set<fs::path> HostileFiles(const fs::path& data, const std::string& extension)
{
  std::set<fs::path> files;
  for (const auto& entry : fs::directory_iterator(data / "hostile"))
  {
    const std::string found = entry.path().extension();
    if (extension.empty() ? found != ".nxv" && found != ".md" : found == extension)
    {
      files.insert(entry.path());
    }
  }
  return files;
}

// Ended by itself, and said no more than fits a screen or two.
void ExpectOrderly(const ProgramRun& run, const fs::path& file)
{
  EXPECT_TRUE(run.status == 0 || run.status == 1 || run.status == 3)
    << file << ": " << run.status << ' ' << run.errors.substr(0, 500);
  EXPECT_EQ(run.errors.find("bad_alloc"), std::string::npos) << file;
  EXPECT_LT(run.errors.size() + run.output.size(), 300'000U) << file;
}

constexpr rlim_t threeGibibytes = rlim_t(3) << 30;

} // namespace

TEST(HostileFiles, InfoSaysWhatIsWrong)
{
  NEXRAD_REQUIRE_TEST_DATA(data);
  if (!fs::exists(data / "hostile"))
  {
    GTEST_SKIP() << "no folder hostile beside the real files";
  }
  const MemoryLimit limit(threeGibibytes);
  for (const fs::path& file : HostileFiles(data, ""))
  {
    ExpectOrderly(RunNexrad3d({"info", file}), file);
  }
}

// Each beside five volumes of a real radar: the rest of the day is made.
TEST(HostileFiles, TheRestOfTheDayIsMade)
{
  NEXRAD_REQUIRE_TEST_DATA(data);
  if (!fs::exists(data / "hostile"))
  {
    GTEST_SKIP() << "no folder hostile beside the real files";
  }
  const MemoryLimit limit(threeGibibytes);
  for (const fs::path& file : HostileFiles(data, ""))
  {
    const TemporaryFolder folder;
    const ProgramRun run =
      RunNexrad3d({"grid", file, data / "level2" / "run-kbgm-20050821", "-o", folder.Path() / "v",
        "--dims", "32x32x8", "--begin", "2005-08-21T02:45", "--end", "2005-08-21T02:50"});
    ExpectOrderly(run, file);
    EXPECT_TRUE(fs::exists(folder.Path() / "v" / "20050821T025000Z.nxv")) << file << run.errors;
  }
}

TEST(HostileFiles, AMergeAtTheirOwnTimeDoesNotCrash)
{
  NEXRAD_REQUIRE_TEST_DATA(data);
  if (!fs::exists(data / "hostile"))
  {
    GTEST_SKIP() << "no folder hostile beside the real files";
  }
  const MemoryLimit limit(threeGibibytes);
  for (const fs::path& file : HostileFiles(data, ""))
  {
    const TemporaryFolder folder;
    ExpectOrderly(RunNexrad3d({"grid", file, "-o", folder.Path() / "v", "--dims", "32x32x8",
                    "--begin", "2019-10-02T08:15", "--end", "2019-10-02T08:15"}),
      file);
  }
}

TEST(HostileFiles, VolumesAreRefusedWithOneLine)
{
  NEXRAD_REQUIRE_TEST_DATA(data);
  if (!fs::exists(data / "hostile"))
  {
    GTEST_SKIP() << "no folder hostile beside the real files";
  }
  const MemoryLimit limit(threeGibibytes);
  for (const fs::path& file : HostileFiles(data, ".nxv"))
  {
    try
    {
      nexrad::application::OpenVolumeFiles({file})->Load(0, {});
      ADD_FAILURE() << file;
    }
    catch (const nexrad::Error& problem)
    {
      const std::string line = problem.what();
      EXPECT_EQ(line.find(file), 0U) << line;
      EXPECT_LT(line.size(), 400U) << file;
    }
  }
}

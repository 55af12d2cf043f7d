// SPDX-License-Identifier: BSD-3-Clause
#include "Comparison/NetCDFContent.h"
#include "ProgramRun.h"
#include "TestData.h"
#include "nexrad/Codec/NxvFile.h"

#include <gtest/gtest.h>

#include <chrono>
#include <filesystem>
#include <string>
#include <vector>

using namespace nexrad;
using namespace nexrad::testing;
namespace fs = std::filesystem;

namespace
{

// Three radars of New York, at 01:15 and 01:20 UTC.
ProgramRun GridThreeRadars(
  const fs::path& data, const fs::path& output, const std::vector<std::string>& options)
{
  std::vector<std::string> arguments = {"grid"};
  for (const char* name :
    {"KBGM20100911_012056_V03.gz", "KENX20100911_011108_V03.gz", "KTYX20100911_012210_V04.gz"})
  {
    arguments.push_back(data / "level2" / "multisite-20100911" / name);
  }
  arguments.insert(
    arguments.end(), {"-o", output, "--begin", "2010-09-11T01:15", "--end", "2010-09-11T01:20",
                       "--dims", "48x40x16", "--moment", "REF,VEL", "--ancillary", "--quiet"});
  arguments.insert(arguments.end(), options.begin(), options.end());
  return RunNexrad3d(arguments);
}

} // namespace

// Values, states and ancillary arrays are those of exact .nxv files, in one file for each time and
// in one for both.
TEST(GridNetCDF, HasWhatExactVolumesHave)
{
  NEXRAD_REQUIRE_TEST_DATA(data);
  const TemporaryFolder folder;
  const fs::path exact = folder.Path() / "exact";
  const fs::path each = folder.Path() / "each";
  const fs::path one = folder.Path() / "one";
  ASSERT_EQ(GridThreeRadars(data, exact, {"--code", "exact"}).status, 0);
  ASSERT_EQ(GridThreeRadars(data, each, {"--format", "nc"}).status, 0);
  ASSERT_EQ(GridThreeRadars(data, one, {"--format", "nc", "--one-file"}).status, 0);
  EXPECT_TRUE(fs::exists(each / "volumes.nc.series"));
  EXPECT_EQ(std::distance(fs::directory_iterator(one), {}), 1);
  const NetCDFContent all(one / "volumes.nc");
  ASSERT_EQ(all.Numbers("time").size(), 2);
  std::size_t time = 0;
  for (const char* name : {"20100911T011500Z", "20100911T012000Z"})
  {
    const GriddedVolume expected = ReadNxv(exact / (name + std::string(".nxv")));
    EXPECT_EQ(expected.sitePositions.size(), 3);
    EXPECT_EQ(expected.further.size(), 1);
    ExpectVolume(NetCDFContent(each / (name + std::string(".nc"))), 0, expected);
    ExpectVolume(all, time++, expected);
  }
}

// A run that goes on in the same folder replaces the file as a whole.
TEST(GridNetCDF, OneFileIsReplacedAsAWhole)
{
  NEXRAD_REQUIRE_TEST_DATA(data);
  const TemporaryFolder folder;
  const std::vector<std::string> options = {"--format", "nc", "--one-file"};
  ASSERT_EQ(GridThreeRadars(data, folder.Path(), options).status, 0);
  ASSERT_EQ(GridThreeRadars(data, folder.Path(), options).status, 0);
  EXPECT_EQ(std::distance(fs::directory_iterator(folder.Path()), {}), 1);
  EXPECT_EQ(NetCDFContent(folder.Path() / "volumes.nc").Numbers("time").size(), 2);
}

// Nothing in a file tells when it was written.
TEST(GridNetCDF, TheSameCommandMakesTheSameBytes)
{
  NEXRAD_REQUIRE_TEST_DATA(data);
  const TemporaryFolder folder;
  for (const char* run : {"first", "second"})
  {
    const auto now = std::chrono::system_clock::to_time_t(std::chrono::system_clock::now());
    while (std::chrono::system_clock::to_time_t(std::chrono::system_clock::now()) == now)
    {
    }
    ASSERT_EQ(GridThreeRadars(data, folder.Path() / run, {"--format", "nc"}).status, 0);
  }
  for (const char* name : {"20100911T011500Z.nc", "20100911T012000Z.nc"})
  {
    EXPECT_TRUE(
      FileContent(folder.Path() / "first" / name) == FileContent(folder.Path() / "second" / name))
      << name;
  }
}

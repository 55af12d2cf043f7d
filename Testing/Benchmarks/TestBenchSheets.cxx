// SPDX-License-Identifier: BSD-3-Clause
#include "NoDisplay.h"
#include "ProgramRun.h"
#include "TestData.h"
#include "Tolerance.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <filesystem>

using namespace nexrad::testing;
namespace fs = std::filesystem;
using Json = nlohmann::json;

namespace
{

Json NumbersOf(const fs::path& folder, const std::string& sheet)
{
  EXPECT_EQ(FileContent(folder / (sheet + ".png")).substr(1, 3), "PNG");
  return Json::parse(FileContent(folder / (sheet + ".json")));
}

} // namespace

// Sheets of five real volumes at a small size, each with its numbers.
TEST(BenchSheets, DrawTheExperimentsOfRealFiles)
{
  NEXRAD_REQUIRE_TEST_DATA(data);
  const TemporaryFolder folder;
  const fs::path sheets = folder.Path() / "sheets";
  const ProgramRun run =
    RunNexrad3d({"bench", data / "level2" / "run-kbgm-20050821", "--sheets", sheets, "--size",
      "160x120", "--dims", "24x24x12", "--dims", "48x48x24", "--time", "2005-08-21T02:55"});
  ASSERT_EQ(run.status, 0) << run.errors;
  EXPECT_NE(run.output.find("slices.png"), std::string::npos) << run.output;

  const Json resolution = NumbersOf(sheets, "resolution");
  EXPECT_EQ(resolution["synthetic"], false);
  ASSERT_EQ(resolution["rows"].size(), 2U);
  EXPECT_AT_LEAST(
    resolution["rows"][0]["difference"], 6.0, "difference of the coarser resolution, of 255");
  EXPECT_EQ(resolution["rows"][1]["difference"], 0.0);
  EXPECT_AT_LEAST(resolution["rows"][1]["finest_covers_percent"], 0.9,
    "columns that the finest resolution covers, %");

  // More slices come nearer to 2048, and 2048 are 2048.
  const Json slices = NumbersOf(sheets, "slices")["rows"];
  ASSERT_EQ(slices.size(), 8U);
  for (std::size_t i = 1; i < slices.size(); ++i)
  {
    EXPECT_EQ(slices[i]["slices"], 2.0 * slices[i - 1]["slices"].get<double>());
    EXPECT_LT(slices[i]["difference"].get<double>(),
      1.05 * slices[i - 1]["difference"].get<double>() + 0.01);
  }
  EXPECT_AT_LEAST(slices[0]["difference"], 8.0, "difference of the fewest slices, of 255");
  EXPECT_EQ(slices[7]["difference"], 0.0);

  const Json times = NumbersOf(sheets, "times")["rows"];
  ASSERT_EQ(times.size(), 4U); // of 02:45 to 03:10
  EXPECT_EQ(times[0]["time"], "2005-08-21T02:45:00.000Z");
  EXPECT_EQ(times[3]["time"], "2005-08-21T03:10:00.000Z");
  EXPECT_AT_LEAST(times[3]["largest_dbz"], 40.0, "largest value of a real volume, dBZ");

  const Json sweeps = NumbersOf(sheets, "sweeps");
  EXPECT_EQ(sweeps["rows"].size(), 9U);
  EXPECT_NE(
    sweeps["title"].get<std::string>().find("KBGM, 2005-08-21T02:54:54Z"), std::string::npos)
    << sweeps["title"];
}

TEST(BenchSheets, OneSheetAloneAsJson)
{
  NEXRAD_REQUIRE_TEST_DATA(data);
  const TemporaryFolder folder;
  const ProgramRun run =
    RunNexrad3d({"bench", data / "level2" / "run-kbgm-20050821" / "KBGM20050821_030047.gz",
      "--sheets", folder.Path(), "--size", "160x120", "--only", "sweeps", "--json"});
  ASSERT_EQ(run.status, 0) << run.errors;
  EXPECT_EQ(Json::parse(run.output)["tables"]["sweeps"]["rows"].size(), 9U);
  EXPECT_TRUE(fs::exists(folder.Path() / "sweeps.png"));
  EXPECT_FALSE(fs::exists(folder.Path() / "slices.png"));
}

TEST(BenchSheets, SaysWhatItCannotDraw)
{
  NEXRAD_REQUIRE_TEST_DATA(data);
  const TemporaryFolder folder;
  const fs::path file = data / "level2" / "run-kbgm-20050821" / "KBGM20050821_030047.gz";
  // Two files years apart: the steps between them are too many.
  const ProgramRun partly =
    RunNexrad3d({"bench", data / "level2" / "damaged" / "KILN20080107_173809.gz", file, "--sheets",
      folder.Path(), "--size", "160x120", "--dims", "8x8x8", "--only", "times,sweeps", "--time",
      "2005-08-21T03:03"});
  EXPECT_EQ(partly.status, 3);
  EXPECT_NE(partly.errors.find("the sheet times is not drawn: "), std::string::npos)
    << partly.errors;
  EXPECT_FALSE(fs::exists(folder.Path() / "times.png"));
  EXPECT_TRUE(fs::exists(folder.Path() / "sweeps.png"));
  const ProgramRun late =
    RunNexrad3d({"bench", file, "--sheets", folder.Path(), "--time", "2005-08-22"});
  EXPECT_EQ(late.status, 1);
  EXPECT_NE(late.errors.find("the files reach from 2005-08-21T03:00:42"), std::string::npos)
    << late.errors;
  const ProgramRun nothing = RunNexrad3d({"bench",
    data / "level2" / "damaged" / "KJGX19700101_000000_V06", "--sheets", folder.Path() / "none"});
  EXPECT_EQ(nothing.status, 1);
  EXPECT_NE(nothing.errors.find("no file holds a ray of REF"), std::string::npos) << nothing.errors;
  const NoDisplay none;
  const ProgramRun dark = RunNexrad3d({"bench", file, "--sheets", folder.Path() / "dark"});
  EXPECT_EQ(dark.status, 1);
  EXPECT_NE(dark.errors.find("no X display"), std::string::npos) << dark.errors;
  EXPECT_EQ(dark.errors.find('\n'), dark.errors.size() - 1) << dark.errors;
}

TEST(BenchSheets, RefusesOptionsThatBelongElsewhere)
{
  const std::vector<std::vector<std::string>> wrong = {{"--sheets", "x", "--runs", "2"},
    {"--sheets", "x", "--hours", "1"}, {"--sheets", "x", "--only", "grid"},
    {"--sheets", "x", "--compare", "a", "b"}, {"--time", "2005-08-21"}, {"--tilt", "20"},
    {"--only", "slices"}};
  for (std::vector<std::string> arguments : wrong)
  {
    arguments.insert(arguments.begin(), "bench");
    const ProgramRun run = RunNexrad3d(arguments);
    EXPECT_EQ(run.status, 2) << arguments[1] << ": " << run.errors;
    EXPECT_EQ(run.errors.find('\n'), run.errors.size() - 1) << run.errors;
  }
}

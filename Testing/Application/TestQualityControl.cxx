// SPDX-License-Identifier: BSD-3-Clause
// Quality control through the program: grid --quality, and what grid and info say of it.
#include "DirectMerge.h"
#include "ProgramRun.h"
#include "TestData.h"
#include "Tolerance.h"
#include "nexrad/Codec/NxvFile.h"
#include "nexrad/Level2/Level2File.h"
#include "nexrad/Merging/TimeMerge.h"
#include "nexrad/Polar/PolarVolume.h"

#include <nlohmann/json.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <string>
#include <vector>

using namespace nexrad;
using namespace nexrad::testing;
namespace fs = std::filesystem;

namespace
{

constexpr char groundEcho[] = "level2/quality/KLSX19930707_040351.gz";

ProgramRun GridWithQuality(
  const fs::path& file, const fs::path& output, std::vector<std::string> options)
{
  std::vector<std::string> arguments = {
    "grid", file, "-o", output, "--dims", "96x96x24", "--code", "exact"};
  arguments.insert(arguments.end(), options.begin(), options.end());
  return RunNexrad3d(arguments);
}

std::size_t Count(const GriddedVolume& volume, VoxelState state)
{
  return static_cast<std::size_t>(std::count(volume.states.begin(), volume.states.end(), state));
}

} // namespace

// Bit for bit what the words of the file give.
TEST(QualityControl, OffIsAMergeWithoutIt)
{
  NEXRAD_REQUIRE_TEST_DATA(data);
  const TemporaryFolder folder;
  const ProgramRun run =
    GridWithQuality(data / groundEcho, folder.Path() / "off", {"--quality", "off"});
  ASSERT_EQ(run.status, 0) << run.errors;
  EXPECT_EQ(run.output.find("quality control"), std::string::npos) << run.output;
  const GriddedVolume off = ReadOnlyVolume(folder.Path() / "off");
  const PolarVolume words = MakePolarVolume(ReadLevel2(data / groundEcho), MomentName::REF);
  MergeRequest request;
  request.grid = off.grid;
  request.time = off.time;
  const auto expected = nexrad::testing::MergeDirectly({&words}, request);
  EXPECT_TRUE(off.values == expected->values);
  EXPECT_TRUE(off.states == expected->states);
}

TEST(QualityControl, TakesGroundEchoOutByDefault)
{
  NEXRAD_REQUIRE_TEST_DATA(data);
  const TemporaryFolder folder;
  const ProgramRun plain = GridWithQuality(data / groundEcho, folder.Path() / "plain", {});
  ASSERT_EQ(plain.status, 0) << plain.errors;
  EXPECT_NE(plain.output.find("quality control (standard) took out "), std::string::npos)
    << plain.output;
  EXPECT_NE(plain.output.find("ground texture "), std::string::npos) << plain.output;
  ASSERT_EQ(
    GridWithQuality(data / groundEcho, folder.Path() / "off", {"--quality", "off"}).status, 0);
  ASSERT_EQ(
    GridWithQuality(data / groundEcho, folder.Path() / "strict", {"--quality", "strict"}).status,
    0);
  const GriddedVolume standard = ReadOnlyVolume(folder.Path() / "plain");
  const GriddedVolume off = ReadOnlyVolume(folder.Path() / "off");
  const GriddedVolume strict = ReadOnlyVolume(folder.Path() / "strict");
  EXPECT_EQ(Count(off, VoxelState::Filtered), 0U);
  EXPECT_AT_LEAST(Count(standard, VoxelState::Filtered), 400U, "filtered voxels of KLSX 1993");
  EXPECT_GE(Count(strict, VoxelState::Filtered), Count(standard, VoxelState::Filtered));
  EXPECT_LT(Count(standard, VoxelState::Echo), Count(off, VoxelState::Echo));
  // Places that no beam passed stay what they are.
  EXPECT_EQ(Count(standard, VoxelState::NotScanned), Count(off, VoxelState::NotScanned));
}

// Every reason is counted, and the classes are their sums.
TEST(QualityControl, InfoCountsGatesByReason)
{
  NEXRAD_REQUIRE_TEST_DATA(data);
  const std::string file = data / groundEcho;
  const auto echo =
    nlohmann::json::parse(RunNexrad3d({"info", "--json", "--echo", file}).output)[0]["echo"];
  const auto sumOf = [](const nlohmann::json& counts)
  {
    std::size_t sum = 0;
    for (const auto& each : counts)
    {
      sum += each.get<std::size_t>();
    }
    return sum;
  };
  EXPECT_EQ(echo["reasons"].size(), 14U);
  EXPECT_EQ(echo["classes"].size(), 6U);
  EXPECT_EQ(sumOf(echo["reasons"]), echo["gates"].get<std::size_t>());
  EXPECT_EQ(sumOf(echo["classes"]), echo["gates"].get<std::size_t>());
  const auto count = [&echo](const char* name) { return echo["classes"][name].get<std::size_t>(); };
  EXPECT_GT(count("ground"), 1'000U);
  EXPECT_EQ(echo["taken_out"]["standard"].get<std::size_t>(),
    count("ground") + count("spike") + count("receiver_fault") + count("speckle"));
  EXPECT_EQ(echo["taken_out"]["strict"].get<std::size_t>(),
    echo["taken_out"]["standard"].get<std::size_t>() + count("biological"));
  EXPECT_TRUE(
    nlohmann::json::parse(RunNexrad3d({"info", "--json", file}).output)[0]["echo"].is_null());
  const std::string table = RunNexrad3d({"info", "--echo", file}).output;
  EXPECT_NE(table.find("echo: " + std::to_string(echo["gates"].get<std::size_t>()) +
                       " gates of REF with a value: weather "),
    std::string::npos)
    << table;
  EXPECT_NE(table.find("reasons: "), std::string::npos);
}

TEST(QualityControl, WrongUsageIsOneLine)
{
  const ProgramRun unknown = RunNexrad3d({"grid", ".", "-o", "x", "--quality", "much"});
  EXPECT_EQ(unknown.status, 2);
  EXPECT_NE(unknown.errors.find("write off, standard or strict"), std::string::npos)
    << unknown.errors;
  const ProgramRun thesis =
    RunNexrad3d({"grid", ".", "-o", "x", "--method", "thesis", "--quality", "standard"});
  EXPECT_EQ(thesis.status, 2);
  EXPECT_NE(thesis.errors.find("is of the method 'beam'"), std::string::npos) << thesis.errors;
}

// SPDX-License-Identifier: BSD-3-Clause
#include "ProgramRun.h"
#include "TestData.h"
#include "Tolerance.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <string>
#include <vector>

using namespace nexrad::testing;
using Json = nlohmann::json;

namespace
{

ProgramRun Measure(const std::vector<std::string>& arguments)
{
  return RunProgram(NEXRAD_BENCHMARK_TABLES, arguments);
}

} // namespace

// No test looks at the times themselves.
TEST(BenchmarkTables, MeasuresASeriesOfFiles)
{
  NEXRAD_REQUIRE_TEST_DATA(data);
  const ProgramRun run = Measure({data / "level2" / "run-kbgm-20050821", "--dims", "32x32x16",
    "--dims", "128x128x64", "--runs", "1", "--json"});
  ASSERT_EQ(run.status, 0) << run.errors;
  const Json report = Json::parse(run.output);
  EXPECT_FALSE(report["processor"].get<std::string>().empty());
  EXPECT_GE(report["threads"], 1);
  EXPECT_EQ(report["vtk"].get<std::string>().substr(0, 2), "9.");
  EXPECT_TRUE(report["opengl"].is_null()); // nothing was drawn
  EXPECT_EQ(report["runs"], 1);
  EXPECT_EQ(report["synthetic"], false);
  const Json& decode = report["tables"]["decode"]["rows"];
  ASSERT_EQ(decode.size(), 5U);
  EXPECT_EQ(decode[0]["container"], "gzip, 45 records");
  EXPECT_NEAR(decode[0]["ratio"].get<double>(),
    decode[0]["decode_s"]["median"].get<double>() / decode[0]["bare_s"]["median"].get<double>(),
    1e-9);
  EXPECT_GT(decode[0]["info_s"]["median"], 0.0);
  EXPECT_GT(decode[0]["info_ratio"], 0.0);
  const Json& grid = report["tables"]["grid"]["rows"];
  ASSERT_EQ(grid.size(), 2U);
  EXPECT_EQ(grid[0]["dimensions"], "32x32x16");
  EXPECT_EQ(grid[0]["sites"], 1.0);
  // The thesis's figures stand beside its own dimensions alone.
  const Json& processing = report["tables"]["processing"]["rows"];
  EXPECT_TRUE(processing[0]["thesis_s_per_volume"].is_null());
  EXPECT_EQ(processing[1]["thesis_s_per_volume"], 6.0);
  EXPECT_EQ(processing[1]["thesis_min_per_day"], 30.0);
  const Json& sizes = report["tables"]["sizes"]["rows"];
  EXPECT_EQ(sizes[1]["bytes_before"], 1048576.0);
  EXPECT_EQ(sizes[1]["thesis_saved_percent"], 99.1);
  EXPECT_GT(sizes[1]["nxv_bytes_after"], 0.0);
  EXPECT_GT(sizes[1]["run_length_bytes_after"], 0.0);
  const Json& series = report["tables"]["series"]["rows"];
  EXPECT_EQ(series[1]["volumes"], 6.0); // 02:45 to 03:10
  EXPECT_NEAR(series[1]["ratio"].get<double>(),
    series[1]["series_s"]["median"].get<double>() / series[1]["bare_s"]["median"].get<double>(),
    1e-9);
  EXPECT_AT_LEAST(series[1]["peak_mib"], 50.0,
    "peak of the memory of the series, MiB"); // two volumes and five of rays
}

TEST(BenchmarkTables, AFileThatIsNoSeriesIsStillDecoded)
{
  NEXRAD_REQUIRE_TEST_DATA(data);
  const auto file = data / "level2" / "superres" / "example_nexrad_archive_msg31.bz2";
  const ProgramRun run = Measure({file, "--dims", "8x8x8", "--runs", "1", "--only", "decode,grid"});
  EXPECT_EQ(run.status, 3);
  EXPECT_NE(run.output.find("example_nexrad_archive_msg31.bz2"), std::string::npos) << run.output;
  EXPECT_NE(run.errors.find("grid is not measured: "), std::string::npos) << run.errors;
}

TEST(BenchmarkTables, NothingToMeasureIsAFailure)
{
  NEXRAD_REQUIRE_TEST_DATA(data);
  const ProgramRun run =
    Measure({data / "level2" / "damaged" / "KJGX19700101_000000_V06", "--dims", "8x8x8"});
  EXPECT_EQ(run.status, 1) << run.output;
}

TEST(BenchmarkTables, RefusesWhatDoesNotExist)
{
  const ProgramRun method = Measure({"--method", "magic"});
  EXPECT_EQ(method.status, 2);
  EXPECT_NE(method.errors.find("'magic' is no method"), std::string::npos) << method.errors;
  EXPECT_EQ(Measure({"--only", "grid,magic"}).status, 2);
}

// SPDX-License-Identifier: BSD-3-Clause
#include "ProgramRun.h"
#include "TestData.h"
#include "Tolerance.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

using namespace nexrad::testing;
using Json = nlohmann::json;

// Without files the synthetic day is drawn, at the times of the thesis's figure, and says so.
TEST(BenchSyntheticSheets, ShowTheThesissTimesOfTheSyntheticDay)
{
  const TemporaryFolder folder;
  const ProgramRun run = RunNexrad3d({"bench", "--sheets", folder.Path(), "--size", "160x120",
    "--dims", "32x32x16", "--only", "times"});
  ASSERT_EQ(run.status, 0) << run.errors;
  const Json numbers = Json::parse(FileContent(folder.Path() / "times.json"));
  EXPECT_EQ(numbers["synthetic"], true);
  EXPECT_NE(numbers["title"].get<std::string>().find("SYNTHETIC"), std::string::npos);
  const char* const times[] = {"00:10", "06:10", "18:10", "23:10"};
  ASSERT_EQ(numbers["rows"].size(), 4U);
  for (std::size_t i = 0; i < 4; ++i)
  {
    EXPECT_EQ(numbers["rows"][i]["time"], "2006-03-12T" + std::string(times[i]) + ":00.000Z");
    EXPECT_AT_LEAST(
      numbers["rows"][i]["echo_percent"], 1.7, "voxels of echo at a time of the thesis, %");
  }
}

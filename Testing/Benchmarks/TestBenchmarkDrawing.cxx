// SPDX-License-Identifier: BSD-3-Clause
#include "NoDisplay.h"
#include "ProgramRun.h"
#include "Tables/DrawingTables.h"
#include "TestData.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

using namespace nexrad::application;
using namespace nexrad::testing;
using Json = nlohmann::json;

namespace
{

// Times that one can reckon with: seconds, of the thesis's middle size and of another.
DrawingReport MakeReport()
{
  const auto time = [](double median) { return Measurement{median, median / 2, median * 2}; };
  DrawingReport report;
  for (const std::array<int, 3> dimensions : {std::array{256, 256, 128}, std::array{32, 32, 16}})
  {
    DrawingOfSize size;
    size.dimensions = dimensions;
    size.read = time(0.01);
    size.rayCastingRead = time(0.02);
    size.upload = time(0.03);
    size.rayCastingUpload = time(0.05);
    size.frames = {{64, time(0.04), time(0.08)}, {256, time(0.16), time(0.64)}};
    report.sizes.push_back(size);
  }
  return report;
}

double NumberIn(const BenchTable& table, std::size_t row, std::size_t column)
{
  const BenchCell& cell = table.rows.at(row).at(column);
  const auto* time = std::get_if<Measurement>(&cell);
  return time != nullptr ? time->median : std::get<double>(cell);
}

} // namespace

// No figure is invented where the thesis has none: "less than 1" stays, and another size has none.
TEST(DrawingTables, TheStepsOfLoadingAndDrawingBesideTheThesis)
{
  const BenchTable table = MakeRenderingTable(MakeReport(), true);
  EXPECT_NE(table.title.find("SYNTHETIC"), std::string::npos);
  ASSERT_EQ(table.rows.size(), 8U);
  EXPECT_EQ(std::get<std::string>(table.rows[0][2]), "8");
  EXPECT_DOUBLE_EQ(NumberIn(table, 0, 3), 10.0);
  EXPECT_DOUBLE_EQ(NumberIn(table, 0, 4), 20.0);
  EXPECT_DOUBLE_EQ(NumberIn(table, 1, 2), 24.0);
  EXPECT_DOUBLE_EQ(NumberIn(table, 1, 4), 50.0);
  EXPECT_DOUBLE_EQ(NumberIn(table, 2, 2), 122.0);
  EXPECT_DOUBLE_EQ(NumberIn(table, 2, 3), 160.0);
  EXPECT_DOUBLE_EQ(NumberIn(table, 3, 2), 154.0);
  EXPECT_DOUBLE_EQ(NumberIn(table, 3, 3), 200.0); // 10 + 30 + 160 ms
  EXPECT_DOUBLE_EQ(NumberIn(table, 3, 4), 710.0); // 20 + 50 + 640 ms
  for (std::size_t row = 4; row < 8; ++row)
  {
    EXPECT_TRUE(std::holds_alternative<std::monostate>(table.rows[row][2]));
  }
}

TEST(DrawingTables, FramesASecondBesideTheThesis)
{
  const BenchTable table = MakeFrameRateTable(MakeReport(), false);
  EXPECT_EQ(table.title.find("SYNTHETIC"), std::string::npos);
  ASSERT_EQ(table.rows.size(), 4U);
  EXPECT_EQ(NumberIn(table, 0, 1), 64.0);
  EXPECT_EQ(NumberIn(table, 0, 2), 18.0);
  EXPECT_DOUBLE_EQ(NumberIn(table, 0, 3), 1.0 / 0.08);
  EXPECT_DOUBLE_EQ(NumberIn(table, 0, 4), 1.0 / 0.15);
  EXPECT_EQ(NumberIn(table, 1, 2), 8.0);
  EXPECT_DOUBLE_EQ(NumberIn(table, 1, 3), 5.0);
  EXPECT_DOUBLE_EQ(NumberIn(table, 1, 7), 0.25); // 160 / 640 ms
  EXPECT_TRUE(std::holds_alternative<std::monostate>(table.rows[2][2]));
}

// No test looks at the times themselves.
TEST(BenchmarkDrawing, MeasuresASeriesOfFiles)
{
  NEXRAD_REQUIRE_TEST_DATA(data);
  const ProgramRun run = RunProgram(NEXRAD_BENCHMARK_DRAWING,
    {data / "level2" / "run-kbgm-20050821", "--dims", "32x32x16", "--runs", "2", "--json"});
  ASSERT_EQ(run.status, 0) << run.errors;
  const Json report = Json::parse(run.output);
  EXPECT_FALSE(report["opengl"]["vendor"].get<std::string>().empty());
  EXPECT_FALSE(report["opengl"]["renderer"].get<std::string>().empty());
  EXPECT_NE(report["opengl"]["version"].get<std::string>().find('.'), std::string::npos);
  const Json& rendering = report["tables"]["rendering"]["rows"];
  ASSERT_EQ(rendering.size(), 4U);
  EXPECT_GT(rendering[0]["slices_ms"]["median"], 0.0);
  EXPECT_GT(rendering[2]["ray_caster_ms"]["median"], 0.0);
  const Json& rates = report["tables"]["frame_rates"]["rows"];
  ASSERT_EQ(rates.size(), 5U);
  const double slices[] = {64.0, 128.0, 256.0, 512.0, 1024.0};
  for (std::size_t row = 0; row < 5; ++row)
  {
    EXPECT_EQ(rates[row]["slices"], slices[row]);
    EXPECT_GT(rates[row]["fps"], 0.0);
    EXPECT_NEAR(rates[row]["ratio"].get<double>(),
      rates[row]["t3_ms"]["median"].get<double>() /
        rates[row]["ray_caster_t3_ms"]["median"].get<double>(),
      1e-9);
  }
}

// Without a display drawing cannot be measured, and one line says why.
TEST(BenchmarkDrawing, NeedsADisplay)
{
  NEXRAD_REQUIRE_TEST_DATA(data);
  const NoDisplay none;
  const ProgramRun run = RunProgram(NEXRAD_BENCHMARK_DRAWING,
    {data / "level2" / "run-kbgm-20050821", "--dims", "16x16x8", "--runs", "1"});
  EXPECT_EQ(run.status, 1);
  EXPECT_NE(run.errors.find("drawing is not measured: no X display"), std::string::npos)
    << run.errors;
  EXPECT_EQ(run.errors.find('\n'), run.errors.size() - 1) << run.errors;
}

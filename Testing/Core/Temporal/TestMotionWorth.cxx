// SPDX-License-Identifier: BSD-3-Clause
// Formulas A4: what interpolation along the motion is worth beside the linear one, on the synthetic
// day and on a run of real volumes. The middle one of each three volumes of a radar is left out and
// rebuilt; the table is printed.
#include "Gridding/BeamMerge.h"
#include "Gridding/ThesisMerge.h"
#include "Level2/Level2File.h"
#include "Simulation/SimulatedDay.h"
#include "Temporal/LeaveOneOut.h"
#include "Temporal/SiteSeries.h"
#include "TestData.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <optional>
#include <string>
#include <vector>

using namespace nexrad;
using namespace std::chrono_literals;

namespace
{

enum class Method
{
  Thesis,
  Beam
};
constexpr Method methods[] = {Method::Thesis, Method::Beam};

std::string Describe(const char* site, Method method, int columns)
{
  return std::string(site) + (method == Method::Beam ? ", beam, " : ", thesis, ") +
         std::to_string(columns);
}

// One volume on the grid, as it was scanned: what it holds is not moved to one time.
GriddedVolume GridAlone(const PolarVolume& volume, const GridSpecification& grid, Method method)
{
  return method == Method::Beam ? BeamMerger(grid).Merge({&volume}, volume.start).value()
                                : MergeThesis({{&volume, nullptr}}, grid, volume.start).value();
}

// Scores of all triples of consecutive volumes of one radar.
LeaveOneOutScore ScoreTriples(
  const std::vector<PolarVolume>& volumes, const std::array<int, 3>& dimensions, Method method)
{
  GridRequest request;
  request.dimensions = dimensions;
  const GridSpecification grid = MakeGrid(request, {volumes.at(0).site.position.value()});
  std::vector<GriddedVolume> window;
  LeaveOneOutScore sum;
  for (const PolarVolume& volume : volumes)
  {
    window.push_back(GridAlone(volume, grid, method));
    if (window.size() > 3)
    {
      window.erase(window.begin());
    }
    if (window.size() == 3)
    {
      const LeaveOneOutScore score = LeaveOneOut(window[0], window[1], window[2]);
      sum.linear += score.linear;
      sum.alongMotion += score.alongMotion;
    }
  }
  return sum;
}

// In brackets, the squares as a mean over `common` voxels, those that the linear RMSE has: the
// linear result blurs echo over more voxels than the other, with small differences in many of them.
void PrintRow(const char* what, const char* way, const RebuildScore& score, std::size_t common)
{
  std::printf("%-22s %-12s RMSE %5.2f dBZ (%5.2f over %zu)  CSI %.3f %.3f %.3f\n", what, way,
    score.Rmse(), common > 0 ? std::sqrt(score.squares / static_cast<double>(common)) : 0.0, common,
    score.SuccessIndex(0), score.SuccessIndex(1), score.SuccessIndex(2));
}

void Print(const std::string& what, const LeaveOneOutScore& score)
{
  const std::size_t common = score.linear.compared;
  PrintRow(what.c_str(), "linear", score.linear, common);
  PrintRow(what.c_str(), "along motion", score.alongMotion, common);
}

std::vector<PolarVolume> ScanHour(const StormField& field, const std::string& site)
{
  SimulatedDayOptions options;
  options.begin = *ParseIso8601("2006-03-12T18:00:00Z");
  options.length = 1h;
  std::vector<PolarVolume> volumes;
  for (const SimulatedVolume& plan : PlanSimulatedDay(options))
  {
    if (plan.site.name == site)
    {
      volumes.push_back(MakePolarVolume(
        ScanVolume(field, plan.site, plan.coveragePattern, plan.start, {}), MomentName::REF));
    }
  }
  return volumes;
}

class MotionWorth : public ::testing::TestWithParam<const char*>
{
};

} // namespace

TEST_P(MotionWorth, OnTheSyntheticDay)
{
  const StormField field;
  const std::vector<PolarVolume> volumes = ScanHour(field, GetParam());
  for (const Method method : methods)
  {
    const LeaveOneOutScore score = ScoreTriples(volumes, {128, 128, 64}, method);
    Print(Describe(GetParam(), method, 128), score);
    EXPECT_GT(score.linear.compared, 100'000u);
    EXPECT_LT(score.alongMotion.Rmse(), 0.75 * score.linear.Rmse());
    EXPECT_LT(score.alongMotion.squares, 0.75 * score.linear.squares);
    for (std::size_t i = 0; i < RebuildScore::Thresholds.size(); ++i)
    {
      EXPECT_GT(score.alongMotion.SuccessIndex(i), score.linear.SuccessIndex(i));
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Sites, MotionWorth, ::testing::Values("KEAX", "KILX", "KLSX"),
  [](const auto& parameter) { return std::string(parameter.param); });

TEST(MotionWorthOf, ARealRun)
{
  NEXRAD_REQUIRE_TEST_DATA(data);
  std::vector<std::filesystem::path> files;
  for (const auto& entry :
    std::filesystem::directory_iterator(data / "level2" / "run-kbgm-20050821"))
  {
    files.push_back(entry.path());
  }
  std::sort(files.begin(), files.end());
  ASSERT_EQ(files.size(), 5u);
  std::vector<PolarVolume> volumes;
  for (const auto& file : files)
  {
    volumes.push_back(MakePolarVolume(ReadLevel2(file), MomentName::REF));
  }
  for (const Method method : methods)
  {
    for (const int columns : {128, 256})
    {
      const LeaveOneOutScore score = ScoreTriples(volumes, {columns, columns, columns / 2}, method);
      Print(Describe("KBGM", method, columns), score);
      EXPECT_GT(score.linear.compared, 100'000u);
      EXPECT_LT(score.alongMotion.Rmse(), score.linear.Rmse());
      EXPECT_LT(score.alongMotion.squares, score.linear.squares);
      EXPECT_GT(score.alongMotion.SuccessIndex(0), score.linear.SuccessIndex(0));
      EXPECT_GT(score.alongMotion.SuccessIndex(1), score.linear.SuccessIndex(1));
    }
  }
}

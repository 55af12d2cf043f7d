// SPDX-License-Identifier: BSD-3-Clause
// Formulas A4: what interpolation along the motion is worth beside the linear one, on the synthetic
// day and on a run of real volumes. The middle one of each three volumes of a radar is left out and
// rebuilt, from volumes on a grid (A2) and by the merge (A2a); the tables are printed.
#include "Motion/LeaveOneOut.h"
#include "PolarMerge.h"
#include "TestData.h"
#include "Tolerance.h"
#include "nexrad/Grid/MakeGrid.h"
#include "nexrad/Level2/Level2File.h"
#include "nexrad/Model/Elevation.h"
#include "nexrad/Motion/MotionTracker.h"
#include "nexrad/Polar/SweepPairing.h"
#include "nexrad/Series/Catalogue.h"
#include "nexrad/Simulation/SimulatedDay.h"
#include "nexrad/Thesis/ThesisMerge.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <optional>
#include <string>
#include <vector>

using namespace nexrad;
using namespace nexrad::testing;
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
  BeamMerger merger(grid);
  return method == Method::Beam ? MergePolar(merger, {&volume}, volume.start).value()
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

const PolarSweep* SweepAt(const PolarVolume& volume, const PolarSweep& other)
{
  for (const PolarSweep& sweep : volume.sweeps)
  {
    if (sweep.elevationNumber == other.elevationNumber &&
        std::abs(MedianElevation(sweep) - MedianElevation(other)) < SameTilt)
    {
      return &sweep;
    }
  }
  return nullptr;
}

bool HaveOnePattern(const PolarVolume& volume, const PolarVolume& other)
{
  return volume.sweeps.size() == other.sweeps.size() &&
         std::all_of(volume.sweeps.begin(), volume.sweeps.end(),
           [&other](const PolarSweep& sweep) { return SweepAt(other, sweep) != nullptr; });
}

// The volume with the time of each ray counted from the ray of `middle` that looked the same way,
// so that one merge at `zero` rebuilds each ray of `middle` at its own time. Both have one pattern.
PolarVolume CountFrom(const PolarVolume& middle, const PolarVolume& volume, Time zero)
{
  PolarVolume counted = volume;
  counted.sweeps.clear();
  for (PolarSweep sweep : volume.sweeps)
  {
    const PolarSweep* other = SweepAt(middle, sweep);
    for (PolarRay& ray : sweep.rays)
    {
      const auto apart = [&ray](const PolarRay& each)
      {
        const float degrees = std::abs(each.azimuth - ray.azimuth); // both from 0 to 360
        return std::min(degrees, 360.0F - degrees);
      };
      const auto nearest = std::min_element(other->rays.begin(), other->rays.end(),
        [&apart](const PolarRay& a, const PolarRay& b) { return apart(a) < apart(b); });
      ray.time = zero + (ray.time - nearest->time);
    }
    counted.sweeps.push_back(std::move(sweep));
  }
  counted.start = zero + (volume.start - middle.start);
  counted.end = counted.start;
  return counted;
}

// The middle one of three volumes left out of the merge, and what the merge makes of the others.
LeaveOneOutScore ScoreMerge(const PolarVolume& first, const PolarVolume& middle,
  const PolarVolume& last, const GridSpecification& grid)
{
  const Time zero = middle.start;
  const PolarVolume before = CountFrom(middle, first, zero);
  const PolarVolume observed = CountFrom(middle, middle, zero);
  const PolarVolume after = CountFrom(middle, last, zero);
  BeamMerger merger(grid);
  const GriddedVolume wanted = MergePolar(merger, {&observed}, zero).value();
  const BeamVolumes ready = PrepareAll(merger, {&before, &after});
  const auto motion = MotionTracker(grid).Find(ready, zero);
  LeaveOneOutScore score;
  score.linear = ScoreRebuilt(merger.Merge(ready, zero, nullptr).value(), wanted);
  score.alongMotion = ScoreRebuilt(merger.Merge(ready, zero, motion.get()).value(), wanted);
  return score;
}

LeaveOneOutScore ScoreMergeTriples(
  const std::vector<PolarVolume>& volumes, const std::array<int, 3>& dimensions)
{
  GridRequest request;
  request.dimensions = dimensions;
  const GridSpecification grid = MakeGrid(request, {volumes.at(0).site.position.value()});
  LeaveOneOutScore sum;
  for (std::size_t i = 2; i < volumes.size(); ++i)
  {
    // Between patterns the tilts differ, and so does what a radar can see at all.
    if (HaveOnePattern(volumes[i - 2], volumes[i - 1]) &&
        HaveOnePattern(volumes[i - 1], volumes[i]))
    {
      const LeaveOneOutScore score = ScoreMerge(volumes[i - 2], volumes[i - 1], volumes[i], grid);
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

std::vector<PolarVolume> ReadRun(const std::filesystem::path& folder)
{
  std::vector<std::filesystem::path> files;
  for (const auto& entry : std::filesystem::directory_iterator(folder))
  {
    files.push_back(entry.path());
  }
  std::sort(files.begin(), files.end());
  std::vector<PolarVolume> volumes;
  for (const auto& file : files)
  {
    volumes.push_back(MakePolarVolume(ReadLevel2(file), MomentName::REF));
  }
  return volumes;
}

void ExpectBetter(const LeaveOneOutScore& score, double part, std::size_t thresholds)
{
  EXPECT_GT(score.linear.compared, 100'000u);
  EXPECT_AT_MOST(score.alongMotion.Rmse() / score.linear.Rmse(), part,
    "RMSE along the motion, part of that of the linear interpolation");
  EXPECT_AT_MOST(score.alongMotion.squares / score.linear.squares, part * part,
    "square error along the motion, part of that of the linear interpolation");
  for (std::size_t i = 0; i < thresholds; ++i)
  {
    EXPECT_GT(score.alongMotion.SuccessIndex(i), score.linear.SuccessIndex(i));
  }
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
    ExpectBetter(score, 0.75, 3);
  }
  const LeaveOneOutScore score = ScoreMergeTriples(volumes, {128, 128, 64});
  Print(std::string(GetParam()) + ", merge, 128", score);
  ExpectBetter(score, 0.75, 3);
}

INSTANTIATE_TEST_SUITE_P(Sites, MotionWorth, ::testing::Values("KEAX", "KILX", "KLSX"),
  [](const auto& parameter) { return std::string(parameter.param); });

TEST(MotionWorthOf, ARealRun)
{
  NEXRAD_REQUIRE_TEST_DATA(data);
  const std::vector<PolarVolume> volumes = ReadRun(data / "level2" / "run-kbgm-20050821");
  ASSERT_EQ(volumes.size(), 5u);
  for (const int columns : {128, 256})
  {
    const std::array<int, 3> dimensions = {columns, columns, columns / 2};
    for (const Method method : methods)
    {
      const LeaveOneOutScore score = ScoreTriples(volumes, dimensions, method);
      Print(Describe("KBGM", method, columns), score);
      ExpectBetter(score, 1.0, 2);
    }
    const LeaveOneOutScore score = ScoreMergeTriples(volumes, dimensions);
    Print("KBGM, merge, " + std::to_string(columns), score);
    ExpectBetter(score, 0.75, 2);
  }
}

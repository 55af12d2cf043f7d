// SPDX-License-Identifier: BSD-3-Clause
// Compares the method `beam` and the thesis's method with the synthetic storm: the table of
// Documentation/Developer/experiments.md. The refraction of the simulated atmosphere varies; the
// merges assume 4/3.
#include "DirectMerge.h"
#include "ScannedDay.h"
#include "StormFeatures.h"
#include "Tolerance.h"
#include "nexrad/Geometry/SiteGeoreference.h"
#include "nexrad/Merging/TimeMerge.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>
#include <optional>
#include <vector>

using namespace nexrad;
using namespace nexrad::testing;

namespace
{

void PrintFeatures(const GriddedVolume& volume, const Truth& truth)
{
  const EchoTopScore tops = CompareEchoTops(volume, truth);
  const CoreScore cores = CompareCores(volume, truth);
  std::printf("         echo tops %+5.0f m, off by %4.0f m (%zu columns)  cores %zu of %zu, off by "
              "%4.0f m\n",
    tops.meanError, tops.meanAbsoluteError, tops.columns, cores.found, cores.cores,
    cores.meanDistance);
}

// The method as it is by default, along the motion of the echo.
std::optional<GriddedVolume> MergeBeam(const ScannedDay& day, const GridSpecification& grid)
{
  MergeRequest request;
  request.grid = grid;
  request.time = day.At();
  request.loop = ThreadLoop(2);
  return nexrad::testing::MergeDirectly(day.Volumes(), request);
}

// What the method `beam` is held to.
struct Bounds
{
  double rmse;      // dBZ
  double missed;    // of the echo, a part
  double falsePart; // of the false echo of the thesis's method
  double echoTop;   // m, mean error
  const char* missedReason = "";
};

// Both methods against the truth; that of the beams must keep its bounds, and be better than the
// thesis's by what is written at the asserts.
void Compare(const ScannedDay& day, const std::array<int, 3>& dimensions, const Bounds& bounds)
{
  const Truth truth = TruthOn(day, dimensions);
  const auto thesis = MergeThesis(day.Brackets(), truth.grid, day.At());
  const auto beam = MergeBeam(day, truth.grid);
  ASSERT_TRUE(thesis && beam);
  EXPECT_TRUE(beam->synthetic);
  const TruthScore before = CompareWithTruth(*thesis, truth.values, truth.counts);
  const TruthScore now = CompareWithTruth(*beam, truth.values, truth.counts);
  Print("thesis", truth, before);
  PrintFeatures(*thesis, truth);
  Print("beam", truth, now);
  PrintFeatures(*beam, truth);
  EXPECT_AT_MOST(now.rmse, bounds.rmse, "RMSE of beam, dBZ");
  EXPECT_AT_MOST(now.rmse / before.rmse, 0.5, "RMSE of beam, part of the thesis's");
  EXPECT_AT_MOST(now.FalseFraction() / before.FalseFraction(), bounds.falsePart,
    "false echo of beam, part of the thesis's");
  EXPECT_AT_MOST(now.MissedFraction(), bounds.missed, "missed echo of beam, part of the echo",
    bounds.missedReason);
  const EchoTopScore tops = CompareEchoTops(*beam, truth);
  EXPECT_AT_MOST(tops.meanAbsoluteError, bounds.echoTop, "mean error of the echo tops of beam, m");
  EXPECT_AT_MOST(tops.meanAbsoluteError / CompareEchoTops(*thesis, truth).meanAbsoluteError, 0.49,
    "mean error of the echo tops of beam, part of the thesis's");
  const CoreScore cores = CompareCores(*beam, truth);
  EXPECT_AT_LEAST(static_cast<double>(cores.found) / static_cast<double>(cores.cores), 0.7,
    "cores that beam finds, part of all");
  EXPECT_AT_MOST(cores.meanDistance, truth.grid.spacing[0],
    "mean error of the places of the cores of beam, m",
    "the place of a core is that of a voxel: the bound is one voxel");
}

ScannedDay DayOfRefraction(double effectiveRadiusFactor)
{
  SimulatorOptions options;
  options.effectiveRadiusFactor = effectiveRadiusFactor;
  return ScannedDay(Evening(), options);
}

// The same truth, of which only the columns count whose nearest radar is from `nearest` to
// `farthest` m away.
Truth OnlyAtDistance(const Truth& truth, const ScannedDay& day, double nearest, double farthest)
{
  Truth part = truth;
  std::vector<SiteGeoreference> sites;
  for (const Position& position : day.Positions())
  {
    sites.emplace_back(position);
  }
  const std::size_t columns = static_cast<std::size_t>(truth.grid.dimensions[0]) *
                              static_cast<std::size_t>(truth.grid.dimensions[1]);
  for (std::size_t column = 0; column < columns; ++column)
  {
    const auto x = static_cast<int>(column) % truth.grid.dimensions[0];
    const auto y = static_cast<int>(column) / truth.grid.dimensions[0];
    const auto place =
      truth.grid.ToGeographic(truth.grid.Coordinate(0, x), truth.grid.Coordinate(1, y));
    double distance = farthest;
    for (const SiteGeoreference& site : sites)
    {
      distance = std::min(distance, site.Look(place[0], place[1]).groundDistance);
    }
    for (std::size_t i = column; distance < nearest || distance >= farthest; i += columns)
    {
      if (i >= part.counts.size())
      {
        break;
      }
      part.counts[i] = 0;
    }
  }
  return part;
}

} // namespace

// What limits it: the beams widen and the gaps between the tilts grow with the distance. Near a
// radar, where its cone of silence is left to others, the distance is not what counts.
TEST(BeamAccuracy, ByDistance)
{
  const ScannedDay& day = EveningDay();
  const Truth truth = TruthOn(day, {128, 128, 64});
  const auto thesis = MergeThesis(day.Brackets(), truth.grid, day.At());
  const auto beam = MergeBeam(day, truth.grid);
  const std::vector<double> bounds = {0.0, 80e3, 160e3, 240e3, 500e3};
  double before = 0.0;
  for (std::size_t i = 0; i + 1 < bounds.size(); ++i)
  {
    const Truth part = OnlyAtDistance(truth, day, bounds[i], bounds[i + 1]);
    std::printf("nearest radar %.0f to %.0f km away\n", bounds[i] / 1e3, bounds[i + 1] / 1e3);
    const TruthScore old = CompareWithTruth(*thesis, part.values, part.counts);
    const TruthScore now = CompareWithTruth(*beam, part.values, part.counts);
    Print("thesis", part, old);
    Print("beam", part, now);
    EXPECT_AT_MOST(
      now.rmse / old.rmse, 0.7, "RMSE of beam in a belt of distances, part of the thesis's");
    EXPECT_TRUE(i < 2 || now.rmse > 1.2 * before);
    before = now.rmse;
  }
}

TEST(BeamAccuracy, At128)
{
  Compare(EveningDay(), {128, 128, 64}, {3.34, 0.0016, 0.12, 550.0});
}

TEST(BeamAccuracy, At256)
{
  Compare(EveningDay(), {256, 256, 128}, {3.30, 0.0035, 0.15, 560.0});
}

TEST(BeamAccuracy, UnderARefractionOf121)
{
  Compare(DayOfRefraction(1.21), {128, 128, 64}, {3.37, 0.008, 0.07, 450.0});
}

TEST(BeamAccuracy, UnderARefractionOf15)
{
  Compare(DayOfRefraction(1.5), {128, 128, 64},
    {3.88, 0.0004, 0.17, 800.0,
      "no echo is missed: the bound is less than half of what is missed at 4/3"});
}

// SPDX-License-Identifier: BSD-3-Clause
#include "nexrad/Grid/MakeGrid.h"
#include "nexrad/Thesis/ThesisMerge.h"

#include "SweepMaker.h"
#include "Tolerance.h"
#include "nexrad/System/Error.h"
#include "nexrad/Thesis/ThesisGeometry.h"

#include <gtest/gtest.h>

#include <algorithm>

using namespace nexrad;
using nexrad::testing::MakeSweep;
using nexrad::testing::MakeVolume;
using nexrad::testing::NumberSweep;
using nexrad::testing::SetAll;
using nexrad::testing::SetGate;

namespace
{

const Position here = {40.0, -90.0, 0.0};

Time After(double seconds)
{
  return *ParseIso8601("2006-03-12T18:00Z") + Duration(static_cast<int>(seconds * 1000.0));
}

// 20 × 20 × 20 cells of 0.1° × 0.1° × 500 m round the site.
GridSpecification SmallGrid()
{
  GridRequest request;
  request.axes = GridAxes::Geographic;
  request.bounds = GeographicBounds{-91.0, 39.0, -89.0, 41.0};
  request.dimensions = {20, 20, 20};
  request.top = 10'000.0;
  return MakeGrid(request, {});
}

// One ray to the east at 2° with gates at 10, 20, … 80 km.
NumberSweep EastRay()
{
  NumberSweep sweep = MakeSweep(1, 2.0, 1, 8, 10'000.0);
  sweep.rays[0].azimuth = 90.0;
  return sweep;
}

// The voxel of gate `gate` of EastRay: 0.1° of longitude are 8513.3 m at 40° north.
std::size_t EastVoxel(std::size_t gate)
{
  const double range = 10'000.0 * static_cast<double>(gate + 1);
  const ThesisPoint point = ThesisRay(90.0, 2.0, 0.0).Locate(range);
  const auto x = static_cast<std::size_t>(10.0 + point.east / 8'513.3);
  const auto z = static_cast<std::size_t>(point.altitude / 500.0);
  return (z * 20 + 10) * 20 + x;
}

GriddedVolume Merge(const std::vector<SiteBracket>& sites, Time time)
{
  auto volume = MergeThesis(sites, SmallGrid(), time);
  EXPECT_TRUE(volume.has_value());
  return *volume;
}

// What one gate becomes when its two sides hold what `before` and `after` say.
float BlendedGate(const NumberSweep& before, const NumberSweep& after, double seconds)
{
  const PolarVolume first = MakeVolume(here, 0.0, {before});
  const PolarVolume second = MakeVolume(here, 300.0, {after});
  const GriddedVolume volume = Merge({{&first, &second}}, After(seconds));
  const std::size_t voxel = EastVoxel(3);
  return volume.states[voxel] == VoxelState::NotScanned ? -1.0F : volume.values[voxel];
}

} // namespace

TEST(MergeThesis, SamplesFallWhereT1ToT3PutThem)
{
  NumberSweep sweep = EastRay();
  for (std::size_t gate = 0; gate < 8; ++gate)
  {
    SetGate(sweep, 0, gate, 10.0F + static_cast<float>(gate));
  }
  const PolarVolume only = MakeVolume(here, 0.0, {sweep});
  const GriddedVolume volume = Merge({{&only, nullptr}}, After(0.0));
  for (std::size_t gate = 0; gate < 8; ++gate)
  {
    EXPECT_FLOAT_EQ(volume.values[EastVoxel(gate)], 10.0F + static_cast<float>(gate));
    EXPECT_EQ(volume.states[EastVoxel(gate)], VoxelState::Echo);
  }
  EXPECT_EQ(volume.method, "thesis");
  EXPECT_EQ(volume.sites, std::vector<std::string>{"KTST"});
  EXPECT_EQ(volume.fill, 0.0F);
}

TEST(MergeThesisT4, BlendsInTime)
{
  NumberSweep before = EastRay();
  NumberSweep after = EastRay();
  SetGate(before, 0, 3, 20.0F);
  SetGate(after, 0, 3, 60.0F);
  EXPECT_FLOAT_EQ(BlendedGate(before, after, 0.0), 20.0F);
  EXPECT_FLOAT_EQ(BlendedGate(before, after, 75.0), 30.0F);
  EXPECT_FLOAT_EQ(BlendedGate(before, after, 300.0), 60.0F);
}

TEST(MergeThesisT5, BelowThresholdCountsAsZero)
{
  NumberSweep before = EastRay();
  SetGate(before, 0, 3, 40.0F);
  EXPECT_FLOAT_EQ(BlendedGate(before, EastRay(), 75.0), 30.0F);
  EXPECT_FLOAT_EQ(BlendedGate(EastRay(), EastRay(), 75.0), 0.0F);
}

TEST(MergeThesisT5, FoldedAndUnsampledGatesDoNotCount)
{
  NumberSweep before = EastRay();
  SetGate(before, 0, 3, 40.0F);
  for (const GateState state : {GateState::RangeFolded, GateState::NotSampled})
  {
    NumberSweep nothing = EastRay();
    nothing.states[3] = state;
    EXPECT_FLOAT_EQ(BlendedGate(before, nothing, 75.0), 40.0F);
    EXPECT_FLOAT_EQ(BlendedGate(nothing, before, 75.0), 40.0F);
    EXPECT_FLOAT_EQ(BlendedGate(nothing, nothing, 75.0), -1.0F);
  }
}

TEST(MergeThesisT5, ValuesAreLimited)
{
  NumberSweep sweep = EastRay();
  SetGate(sweep, 0, 3, 94.5F);
  EXPECT_FLOAT_EQ(BlendedGate(sweep, sweep, 0.0), 80.0F);
  SetGate(sweep, 0, 3, -20.0F);
  EXPECT_FLOAT_EQ(BlendedGate(sweep, sweep, 0.0), 0.0F);
}

// The ray after points 0.9° aside, and then 1° (more than a beam width, 0.95°).
TEST(MergeThesisT4, TheNearestRayWithinABeamWidthIsThePartner)
{
  NumberSweep before = EastRay();
  NumberSweep after = EastRay();
  SetGate(before, 0, 3, 20.0F);
  SetGate(after, 0, 3, 60.0F);
  after.rays[0].azimuth = 90.9;
  EXPECT_FLOAT_EQ(BlendedGate(before, after, 150.0), 40.0F);
  after.rays[0].azimuth = 91.0;
  EXPECT_FLOAT_EQ(BlendedGate(before, after, 150.0), 20.0F);
}

// Gates of 2.5 km in the volume after: the one at 40 km is number 15.
TEST(MergeThesisT4, TheGateOfTheSameRangeIsThePartner)
{
  NumberSweep before = EastRay();
  SetGate(before, 0, 3, 20.0F);
  NumberSweep after = MakeSweep(1, 2.0, 1, 32, 2'500.0);
  after.rays[0].azimuth = 90.0;
  SetGate(after, 0, 15, 60.0F);
  EXPECT_FLOAT_EQ(BlendedGate(before, after, 150.0), 40.0F);
}

TEST(MergeThesisT4, SweepsOfOneSideAloneGoInUnchanged)
{
  NumberSweep high = MakeSweep(2, 6.0, 1, 8, 10'000.0);
  high.rays[0].azimuth = 90.0;
  SetGate(high, 0, 3, 50.0F);
  const PolarVolume first = MakeVolume(here, 0.0, {EastRay()});
  const PolarVolume second = MakeVolume(here, 300.0, {EastRay(), high});
  const ThesisPoint point = ThesisRay(90.0, 6.0, 0.0).Locate(40'000.0);
  const auto voxel = (static_cast<std::size_t>(point.altitude / 500.0) * 20 + 10) * 20 + 14;
  EXPECT_FLOAT_EQ(Merge({{&first, &second}}, After(10.0)).values[voxel], 50.0F);
  EXPECT_FLOAT_EQ(Merge({{&second, &first}}, After(290.0)).values[voxel], 50.0F);
}

TEST(MergeThesis, OneSideOnlyIsUsedUnchanged)
{
  NumberSweep sweep = EastRay();
  SetGate(sweep, 0, 3, 33.0F);
  const PolarVolume only = MakeVolume(here, 0.0, {sweep});
  EXPECT_FLOAT_EQ(Merge({{&only, nullptr}}, After(500.0)).values[EastVoxel(3)], 33.0F);
  EXPECT_FLOAT_EQ(Merge({{nullptr, &only}}, After(-500.0)).values[EastVoxel(3)], 33.0F);
}

// Two samples of one site and one of another in one cell: (10 + 20 + 60) / 3.
TEST(MergeThesisT6, ACellIsTheMeanOfAllSamplesOfAllSites)
{
  NumberSweep twice = EastRay();
  twice.rays.push_back(twice.rays[0]);
  twice.values.resize(16, twice.values[0]);
  twice.states.resize(16, GateState::BelowThreshold);
  SetGate(twice, 0, 3, 10.0F);
  SetGate(twice, 1, 3, 20.0F);
  NumberSweep other = EastRay();
  SetGate(other, 0, 3, 60.0F);
  const PolarVolume first = MakeVolume(here, 0.0, {twice});
  const PolarVolume second = MakeVolume(here, 0.0, {other});
  const GriddedVolume volume = Merge({{&first, nullptr}, {&second, nullptr}}, After(0.0));
  EXPECT_FLOAT_EQ(volume.values[EastVoxel(3)], 30.0F);
}

TEST(MergeThesisT7, FillsDownButNotUp)
{
  NumberSweep sweep = EastRay();
  SetGate(sweep, 0, 3, 40.0F);
  const PolarVolume only = MakeVolume(here, 0.0, {sweep});
  const GriddedVolume volume = Merge({{&only, nullptr}}, After(0.0));
  const std::size_t voxel = EastVoxel(3);
  EXPECT_FLOAT_EQ(volume.values[voxel % 400], 40.0F) << "the lowest level";
  EXPECT_EQ(volume.states[voxel + 400], VoxelState::NotScanned);
  EXPECT_EQ(volume.values[voxel + 400], volume.fill);
}

TEST(MergeThesis, ScannedAndEmptyIsNoEcho)
{
  const PolarVolume only = MakeVolume(here, 0.0, {EastRay()});
  const GriddedVolume volume = Merge({{&only, nullptr}}, After(0.0));
  EXPECT_EQ(volume.states[EastVoxel(3)], VoxelState::NoEcho);
  EXPECT_EQ(volume.values[EastVoxel(3)], 0.0F);
  EXPECT_EQ(std::count(volume.states.begin(), volume.states.end(), VoxelState::Echo), 0);
}

TEST(MergeThesis, AConstantFieldStaysConstant)
{
  std::vector<NumberSweep> sweeps;
  for (int cut = 1; cut <= 6; ++cut)
  {
    sweeps.push_back(MakeSweep(cut, 0.5 + 2.0 * (cut - 1), 360, 100, 1'000.0));
    SetAll(sweeps.back(), 35.0F);
  }
  const PolarVolume first = MakeVolume(here, 0.0, sweeps);
  const PolarVolume second = MakeVolume({39.6, -90.3, 150.0}, 20.0, sweeps);
  GridRequest request;
  request.dimensions = {40, 40, 30};
  const GridSpecification grid = MakeGrid(request, {here});
  const auto volume = MergeThesis({{&first, &second}, {&second, nullptr}}, grid, After(7.0));
  ASSERT_TRUE(volume);
  std::size_t echoes = 0;
  for (std::size_t i = 0; i < volume->values.size(); ++i)
  {
    if (volume->states[i] == VoxelState::Echo)
    {
      EXPECT_FLOAT_EQ(volume->values[i], 35.0F);
      ++echoes;
    }
    EXPECT_NE(volume->states[i], VoxelState::NoEcho);
  }
  EXPECT_AT_LEAST(echoes, 5'000u, "voxels of echo");
}

TEST(MergeThesis, GatesBeforeTheAntennaAreLeftOut)
{
  NumberSweep sweep = EastRay();
  sweep.firstGate = -10'000.0;
  SetGate(sweep, 0, 0, 70.0F);
  const PolarVolume only = MakeVolume(here, 0.0, {sweep});
  const GriddedVolume volume = Merge({{&only, nullptr}}, After(0.0));
  EXPECT_EQ(std::count(volume.states.begin(), volume.states.end(), VoxelState::Echo), 0);
}

TEST(MergeThesis, NothingInNothingOut)
{
  const GriddedVolume volume = Merge({}, After(0.0));
  EXPECT_EQ(volume.states.size(), 8'000u);
  EXPECT_EQ(std::count(volume.states.begin(), volume.states.end(), VoxelState::NotScanned), 8'000);
}

TEST(MergeThesis, SimulatedInputIsMarked)
{
  PolarVolume only = MakeVolume(here, 0.0, {EastRay()});
  EXPECT_FALSE(Merge({{&only, nullptr}}, After(0.0)).synthetic);
  const PolarVolume real = only;
  only.synthetic = true;
  EXPECT_TRUE(Merge({{&real, &only}}, After(0.0)).synthetic);
  EXPECT_TRUE(Merge({{&only, nullptr}}, After(0.0)).synthetic);
}

TEST(MergeThesis, StopsWhenAsked)
{
  const PolarVolume only = MakeVolume(here, 0.0, {EastRay()});
  EXPECT_FALSE(
    MergeThesis({{&only, nullptr}}, SmallGrid(), After(0.0), [](double) { return false; }));
  double last = -1.0;
  const auto rising = [&last](double done)
  {
    EXPECT_GE(done, last);
    last = done;
    return true;
  };
  EXPECT_TRUE(MergeThesis({{&only, nullptr}}, SmallGrid(), After(0.0), rising));
  EXPECT_DOUBLE_EQ(last, 1.0);
}

TEST(MergeThesis, RefusesAGridWithoutVoxels)
{
  GridSpecification none = SmallGrid();
  none.dimensions[1] = 0;
  EXPECT_THROW(MergeThesis({}, none, After(0.0)), Error);
}

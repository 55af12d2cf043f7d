// SPDX-License-Identifier: BSD-3-Clause
#include "GridMaker.h"
#include "nexrad/Motion/MotionField.h"
#include "nexrad/System/Error.h"

#include <gtest/gtest.h>

#include <limits>

using namespace nexrad;
using nexrad::testing::MakeTestGrid;

TEST(MotionLattice, ReachesFromTheFirstVoxelToTheLast)
{
  // 100 intervals of 1 km in x need 5 of at most 20 km; 50 in y need 3.
  const MotionLattice lattice = MakeMotionLattice(MakeTestGrid({101, 51, 1}, 1000.0), 20'000.0);
  EXPECT_EQ(lattice.nodes, (std::array<int, 2>{6, 4}));
  EXPECT_DOUBLE_EQ(lattice.step[0], 20.0);
  EXPECT_DOUBLE_EQ(lattice.step[1], 50.0 / 3.0);
}

TEST(MotionLattice, HasNoMoreNodesThanVoxels)
{
  const MotionLattice lattice = MakeMotionLattice(MakeTestGrid({3, 1, 1}, 90'000.0), 20'000.0);
  EXPECT_EQ(lattice.nodes, (std::array<int, 2>{3, 1}));
  EXPECT_DOUBLE_EQ(lattice.step[0], 1.0);
}

TEST(MotionLattice, RefusesNodesWithoutDistance)
{
  const GridSpecification grid = MakeTestGrid({3, 3, 1}, 1000.0);
  EXPECT_THROW(MakeMotionLattice(grid, 0.0), Error);
  EXPECT_THROW(MakeMotionLattice(grid, std::numeric_limits<double>::quiet_NaN()), Error);
  EXPECT_THROW(MakeMotionLattice(MakeTestGrid({0, 3, 1}, 1000.0), 1000.0), Error);
}

TEST(MotionField, IsBilinearBetweenNodesAndConstantOutside)
{
  MotionField field;
  field.lattice.nodes = {2, 2};
  field.lattice.step = {10.0, 20.0};
  field.velocities = {{0.0, 1.0}, {8.0, 1.0}, {4.0, 1.0}, {12.0, 5.0}};
  EXPECT_DOUBLE_EQ(field.At(5.0, 0.0).east, 4.0);
  EXPECT_DOUBLE_EQ(
    field.At(2.5, 5.0).east, 0.75 * (0.25 * 8.0) + 0.25 * (0.75 * 4.0 + 0.25 * 12.0));
  EXPECT_DOUBLE_EQ(field.At(5.0, 10.0).north, 2.0);
  EXPECT_DOUBLE_EQ(field.At(-3.0, -1.0).east, 0.0);
  EXPECT_DOUBLE_EQ(field.At(400.0, 400.0).north, 5.0);
}

TEST(MotionField, ConstantIsTheSameEverywhere)
{
  const MotionField field = MotionField::Constant({3.0, -4.0});
  for (const double place : {-1.0, 0.0, 0.5, 300.0})
  {
    EXPECT_DOUBLE_EQ(field.At(place, 2.0 * place).east, 3.0);
    EXPECT_DOUBLE_EQ(field.At(place, 2.0 * place).north, -4.0);
  }
}

// 0.01° of the equator of a sphere of 6371 km are 1111.95 m; at 60° half of it.
TEST(VoxelExtent, NarrowsTowardsThePoleOnGeographicAxes)
{
  GridSpecification grid;
  grid.axes = GridAxes::Geographic;
  grid.origin = {-90.0, 50.0, 0.0};
  grid.spacing = {0.01, 0.02, 500.0};
  EXPECT_NEAR(VoxelExtent(grid, 500.0)[0], 0.5 * 1111.95, 0.01);
  EXPECT_NEAR(VoxelExtent(grid, 500.0)[1], 2.0 * 1111.95, 0.01);
  EXPECT_GT(VoxelExtent(grid, 2000.0)[0], 0.0);
}

TEST(VoxelExtent, IsTheSpacingOnProjectedAxes)
{
  EXPECT_EQ(
    VoxelExtent(MakeTestGrid({9, 9, 1}, 1250.0), 3.0), (std::array<double, 2>{1250.0, 1250.0}));
}

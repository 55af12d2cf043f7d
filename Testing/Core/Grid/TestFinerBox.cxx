// SPDX-License-Identifier: BSD-3-Clause
#include "nexrad/Grid/FinerBox.h"

#include "Tolerance.h"
#include "nexrad/System/Error.h"

#include <gtest/gtest.h>

namespace nexrad
{
namespace
{

GridSpecification Domain()
{
  GridSpecification domain;
  domain.dimensions = {230, 230, 40};
  domain.spacing = {2000.0, 2000.0, 500.0};
  domain.origin = {-229'000.0, -229'000.0, 250.0};
  return domain;
}

} // namespace

TEST(FinerBox, HasVoxelsOf250MetresAndTheHeightOfTheDomain)
{
  const FinerBox box = MakeFinerBox(Domain(), {{10'000.0, 70'000.0, -40'000.0, 20'000.0}});
  const GridSpecification part = PartOf(box.grid, box.block);
  EXPECT_EQ(part.dimensions, (std::array<int, 3>{240, 240, 80}));
  EXPECT_EQ(part.spacing, (std::array<double, 3>{250.0, 250.0, 250.0}));
  EXPECT_NEAR(part.origin[0], 10'125.0, 1e-6);
  EXPECT_NEAR(part.origin[1], -39'875.0, 1e-6);
  EXPECT_NEAR(part.origin[2], 125.0, 1e-6);
}

TEST(FinerBox, BoxesOfOneSizeHaveOneGrid)
{
  const FinerBox box = MakeFinerBox(Domain(), {{10'000.0, 70'000.0, -40'000.0, 20'000.0}});
  const FinerBox other = MakeFinerBox(Domain(), {{-31'110.0, 20'000.0, 0.0, 1.0}});
  EXPECT_TRUE(box.grid == other.grid);
  EXPECT_EQ(other.block.Size(1), 1) << "at least one voxel";
  EXPECT_NEAR(PartOf(other.grid, other.block).origin[0] - 125.0, -31'110.0, 125.0);
}

TEST(FinerBox, CoversVoxelsOfAGivenGrid)
{
  const GridSpecification grid = Domain(); // -230 km to 230 km in 230 voxels
  const auto voxels = [&grid](const std::array<double, 4>& faces)
  { return VoxelsOfBox(grid, {faces}); };
  EXPECT_EQ(voxels({-900'000.0, 900'000.0, -900'000.0, 900'000.0}), VoxelBlock::Of(grid));
  EXPECT_EQ(
    voxels({-228'500.0, 10'000.0, 0.0, 20'900.0}), (VoxelBlock{{1, 115, 0}, {120, 125, 40}}));
  EXPECT_EQ(
    voxels({100.0, 200.0, 229'900.0, 240'000.0}), (VoxelBlock{{115, 228, 0}, {117, 230, 40}}))
    << "two at least";
  EXPECT_THROW(voxels({230'000.0, 240'000.0, 0.0, 1000.0}), Error);
  BoxRequest request;
  request.spacing = 3999.0;
  EXPECT_FALSE(IsFinerThanAsked(grid, request));
  request.spacing = 4000.0;
  EXPECT_TRUE(IsFinerThanAsked(grid, request));
}

TEST(FinerBox, AWideBoxHasLargerVoxelsAndEndsWithTheDomain)
{
  const FinerBox box = MakeFinerBox(Domain(), {{110'000.0, 900'000.0, -230'000.0, 230'000.0}});
  const GridSpecification part = PartOf(box.grid, box.block);
  EXPECT_EQ(part.dimensions, (std::array<int, 3>{240, 240, 80}));
  EXPECT_NEAR(part.spacing[0], 500.0, 1e-6);
  EXPECT_NEAR(part.spacing[1], 460'000.0 / 240.0, 1e-6);
}

TEST(FinerBox, ABoxThatMovedHasTheSameVoxelsAndStaysInTheDomain)
{
  const BoxRequest request = {{10'000.0, 70'000.0, -40'000.0, 20'000.0}};
  const FinerBox first = MakeFinerBox(Domain(), request);
  const FinerBox moved = MakeFinerBox(Domain(), request, {1'370.0, -20'000.0});
  EXPECT_TRUE(moved.grid == first.grid);
  const GridSpecification part = PartOf(moved.grid, moved.block);
  EXPECT_EQ(part.dimensions, (std::array<int, 3>{240, 240, 80}));
  EXPECT_NEAR(part.origin[0] - 125.0, 11'370.0, 125.0);
  EXPECT_NEAR(part.origin[1] - 125.0, -60'000.0, 1e-6);
  const FinerBox far = MakeFinerBox(Domain(), request, {900'000.0, -900'000.0});
  EXPECT_NEAR(PartOf(far.grid, far.block).origin[0] - 125.0, 170'000.0, 1e-6);
  EXPECT_NEAR(PartOf(far.grid, far.block).origin[1] - 125.0, -230'000.0, 1e-6);
  EXPECT_EQ(far.block.Size(0), 240);
  EXPECT_EQ(RoomToMove(Domain(), request),
    (std::array<double, 4>{-240'000.0, 160'000.0, -190'000.0, 210'000.0}));
}

TEST(FinerBox, ACoarseDomainIsTheWholeAndNoFiner)
{
  GridSpecification usual;
  usual.dimensions = {256, 200, 128};
  usual.spacing = {1800.0, 2304.0, 156.25};
  usual.origin = {-229'500.0, -229'248.0, 78.125};
  const FinerBox coarse = MakeFinerBox(usual, CoarseDomain(usual));
  EXPECT_EQ(coarse.grid.dimensions, (std::array<int, 3>{128, 128, 64}));
  EXPECT_EQ(coarse.block.Size(0), 128);
  EXPECT_NEAR(coarse.grid.spacing[1], 3600.0, 1e-6);
  GridSpecification small = usual;
  small.dimensions = {64, 50, 32};
  small.spacing = {7200.0, 9216.0, 625.0};
  small.origin = {-226'800.0, -225'792.0, 312.5};
  EXPECT_EQ(
    MakeFinerBox(small, CoarseDomain(small)).grid.dimensions, (std::array<int, 3>{64, 64, 32}));
}

TEST(FinerBox, RefusesABoxBesideTheDomain)
{
  EXPECT_THROW(MakeFinerBox(Domain(), {{240'000.0, 300'000.0, 0.0, 10'000.0}}), Error);
  EXPECT_THROW(MakeFinerBox(Domain(), {{20'000.0, 10'000.0, 0.0, 10'000.0}}), Error);
  EXPECT_THROW(MakeFinerBox(Domain(), {{0.0, 10'000.0, 0.0, 10'000.0}, 0.0}), Error);
}

} // namespace nexrad

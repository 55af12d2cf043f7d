// SPDX-License-Identifier: BSD-3-Clause
#include "StateNames.h"
#include "nexrad/Products/ColumnProducts.h"

#include "nexrad/Model/SiteTable.h"
#include "nexrad/System/Error.h"

#include <gtest/gtest.h>

#include <atomic>
#include <cmath>
#include <string>
#include <vector>

using namespace nexrad;
using namespace nexrad::testing;

namespace
{

constexpr VoxelState filtered = VoxelState::Filtered;

// A column of levels of 1 km, the first at 500 m.
GriddedVolume ColumnOf(const std::vector<VoxelState>& states, const std::vector<float>& values)
{
  GriddedVolume volume;
  volume.grid.dimensions = {1, 1, static_cast<int>(states.size())};
  volume.grid.origin = {0.0, 0.0, 500.0};
  volume.grid.spacing = {1'000.0, 1'000.0, 1'000.0};
  volume.states = states;
  volume.values = values;
  return volume;
}

ColumnProduct TopOf(const std::vector<VoxelState>& states, const std::vector<float>& values)
{
  return MakeEchoTops(LinesOf(ColumnOf(states, values)), 18.0);
}

} // namespace

TEST(ColumnProducts, AnEchoTopLiesBetweenTheLevelsAboutTheThreshold)
{
  const ColumnProduct top = TopOf({echo, echo, echo, echo}, {50.0F, 28.0F, 8.0F, 2.0F});
  EXPECT_EQ(top.states[0], echo);
  EXPECT_FLOAT_EQ(top.values[0], 2'000.0F); // half way from 28 dBZ at 1.5 km to 8 at 2.5 km
}

TEST(ColumnProducts, AnEchoTopIsSoughtFromAbove)
{
  const ColumnProduct top = TopOf({echo, echo, echo, echo}, {50.0F, 8.0F, 20.0F, 16.0F});
  EXPECT_FLOAT_EQ(top.values[0], 3'000.0F);
}

TEST(ColumnProducts, WithoutAnEchoAboveTheTopIsTheVoxelItself)
{
  for (const VoxelState above : {none, open, folded})
  {
    EXPECT_FLOAT_EQ(TopOf({echo, above}, {30.0F, -33.0F}).values[0], 500.0F);
  }
  EXPECT_FLOAT_EQ(TopOf({echo, echo}, {30.0F, 30.0F}).values[0], 1'500.0F);
}

TEST(ColumnProducts, ColumnsWithoutATopSayWhy)
{
  EXPECT_EQ(TopOf({echo, none}, {10.0F, -33.0F}).states[0], none)
    << "too weak: scanned, none there";
  EXPECT_EQ(TopOf({none, open}, {-33.0F, -33.0F}).states[0], none);
  EXPECT_EQ(TopOf({open, folded}, {-33.0F, -33.0F}).states[0], folded);
  EXPECT_EQ(TopOf({open, open}, {-33.0F, -33.0F}).states[0], open);
  EXPECT_EQ(TopOf({filtered, open}, {-33.0F, -33.0F}).states[0], filtered);
  EXPECT_EQ(TopOf({filtered, folded}, {-33.0F, -33.0F}).states[0], folded);
  EXPECT_EQ(TopOf({filtered, none}, {-33.0F, -33.0F}).states[0], none);
}

// By hand: 40 dBZ is Z = 10⁴, to the power of 4/7 193.07; 20 dBZ 13.895; 56 dBZ 1584.9. The sum
// 1791.9 times 3.44e-6 times 1000 m.
TEST(ColumnProducts, IntegratedLiquidIsThatOfTheFormula)
{
  const ColumnProduct liquid = MakeIntegratedLiquid(
    LinesOf(ColumnOf({echo, echo, none, echo, open}, {40.0F, 20.0F, -33.0F, 65.0F, -33.0F})));
  EXPECT_EQ(liquid.states[0], echo);
  EXPECT_NEAR(static_cast<double>(liquid.values[0]), 6.1641, 0.001);
}

TEST(ColumnProducts, AWeakEchoAddsLittleAndNoEchoNothing)
{
  EXPECT_NEAR(
    static_cast<double>(MakeIntegratedLiquid(LinesOf(ColumnOf({echo}, {-10.0F}))).values[0]),
    3.44e-3 * std::pow(0.1, 4.0 / 7.0), 1e-8);
  EXPECT_EQ(MakeIntegratedLiquid(LinesOf(ColumnOf({none}, {-33.0F}))).states[0], none);
}

// By hand: 50 dBZ is Z = 10⁵, to the power of 4/7 719.69; 28 dBZ 39.811, 8 dBZ 2.8649. The sum
// 762.36 times 3.44e-6 times 1000 m is 2.62253 kg/m²; the echo top of 18 dBZ is at 2000 m, that of
// 40 dBZ at 500 m + 10/22 · 1000 m.
TEST(ColumnProducts, LiquidDensityIsLiquidThroughTheEchoTop)
{
  const GriddedVolume column = ColumnOf({echo, echo, echo, none}, {50.0F, 28.0F, 8.0F, -33.0F});
  const ColumnProduct usual = MakeLiquidDensity(LinesOf(column), 18.0);
  EXPECT_EQ(usual.states[0], echo);
  EXPECT_NEAR(static_cast<double>(usual.values[0]), 1.31126, 0.0002);
  const ColumnProduct higher = MakeLiquidDensity(LinesOf(column), 40.0);
  EXPECT_NEAR(static_cast<double>(higher.values[0]), 2.74741, 0.0004);
}

// KFTG's ground is at 1675 m by the site table, KDDC's at 789 m. By hand, of the same column 2000 m
// higher: 2.62253 kg/m² through 4000 m − 1675 m and through 4000 m − 789 m.
TEST(ColumnProducts, LiquidDensityCountsFromTheGroundAtTheNearestRadar)
{
  ASSERT_EQ(FindSite("KFTG")->ground, 1675.0);
  ASSERT_EQ(FindSite("KDDC")->ground, 789.0);
  const auto densityNear = [](const std::string& site)
  {
    GriddedVolume column = ColumnOf({echo, echo, echo, none}, {50.0F, 28.0F, 8.0F, -33.0F});
    column.grid.origin[2] += 2'000.0;
    column.grid.centreLatitude = FindSite(site)->position.latitude;
    column.grid.centreLongitude = FindSite(site)->position.longitude;
    column.sites = {"KFTG", "KDDC"};
    return static_cast<double>(MakeLiquidDensity(LinesOf(column), 18.0).values[0]);
  };
  EXPECT_NEAR(densityNear("KFTG"), 2622.53 / (4'000.0 - 1'675.0), 0.0002);
  EXPECT_NEAR(densityNear("KDDC"), 2622.53 / (4'000.0 - 789.0), 0.0002);
}

TEST(ColumnProducts, WithoutAnEchoTopThereIsNoLiquidDensity)
{
  const auto stateOf = [](const GriddedVolume& column)
  { return MakeLiquidDensity(LinesOf(column), 18.0).states[0]; };
  EXPECT_EQ(stateOf(ColumnOf({echo, none}, {10.0F, -33.0F})), none) << "liquid, but no top";
  EXPECT_EQ(stateOf(ColumnOf({open, folded}, {-33.0F, -33.0F})), folded);
  GriddedVolume below = ColumnOf({echo}, {50.0F});
  below.grid.origin[2] = -20.0; // m, and the top with it
  EXPECT_EQ(stateOf(below), none);
}

TEST(ColumnProducts, AreOfReflectivityAlone)
{
  GriddedVolume volume = ColumnOf({echo}, {10.0F});
  volume.moment = MomentName::VEL;
  EXPECT_THROW(MakeEchoTops(LinesOf(volume), 18.0), Error);
  EXPECT_THROW(MakeIntegratedLiquid(LinesOf(volume)), Error);
  EXPECT_THROW(MakeLiquidDensity(LinesOf(volume), 18.0), Error);
}

// More columns than are visited together.
TEST(VoxelLines, EachColumnIsVisitedFromItsLowestLevelUp)
{
  GriddedVolume volume;
  volume.grid.dimensions = {91, 97, 3};
  for (std::size_t i = 0; i < volume.grid.VoxelCount(); ++i)
  {
    volume.values.push_back(static_cast<float>(i));
    volume.states.push_back(i % 2 == 0 ? echo : none);
  }
  for (const unsigned threads : {1U, 3U})
  {
    std::vector<int> next(91 * 97, 0);
    std::atomic<int> wrong{0};
    const auto visit = [&](const ColumnStretch& stretch)
    {
      for (std::size_t i = 0; i < stretch.count; ++i)
      {
        const std::size_t column = stretch.first + i;
        const std::size_t voxel = column + next.size() * static_cast<std::size_t>(stretch.level);
        const bool right = next[column] == stretch.level &&
                           stretch.values[i] == volume.values[voxel] &&
                           stretch.states[i] == volume.states[voxel];
        wrong += right ? 0 : 1;
        next[column] = stretch.level + 1;
      }
    };
    WalkColumns(LinesOf(volume), 0, 3, ThreadLoop(threads), visit);
    EXPECT_EQ(wrong.load(), 0);
    EXPECT_EQ(next, std::vector<int>(91 * 97, 3));
  }
}

// SPDX-License-Identifier: BSD-3-Clause
#include "nexrad/Polar/SweepPairing.h"

#include "SweepMaker.h"

#include <gtest/gtest.h>

using namespace nexrad;
using nexrad::testing::MakeSweep;
using nexrad::testing::MakeVolume;
using nexrad::testing::NumberSweep;

namespace
{

struct Cut
{
  int number;
  double elevation;
};

PolarVolume VolumeOf(const std::vector<Cut>& cuts)
{
  std::vector<NumberSweep> sweeps;
  for (const Cut& cut : cuts)
  {
    sweeps.push_back(MakeSweep(cut.number, cut.elevation, 4, 1));
  }
  return MakeVolume({40.0, -90.0, 0.0}, 0.0, sweeps);
}

using Pairs = std::vector<std::optional<std::size_t>>;

} // namespace

TEST(PairSweepsT4, SamePatternPairsInOrder)
{
  const PolarVolume before = VolumeOf({{1, 0.48}, {3, 1.45}, {5, 2.41}});
  const PolarVolume after = VolumeOf({{1, 0.53}, {3, 1.41}, {5, 2.41}});
  EXPECT_EQ(PairSweeps(before, after), (Pairs{0, 1, 2}));
}

// The low cut scanned again in the middle of the volume pairs with its like, not with the first.
TEST(PairSweepsT4, RepeatedLowCutsPairWithTheirLike)
{
  const PolarVolume before = VolumeOf({{1, 0.5}, {3, 1.3}, {5, 0.5}, {7, 2.4}});
  EXPECT_EQ(PairSweeps(before, before), (Pairs{0, 1, 2, 3}));
  const PolarVolume after = VolumeOf({{1, 0.5}, {3, 1.3}, {4, 2.4}, {6, 0.5}});
  EXPECT_EQ(PairSweeps(before, after), (Pairs{0, 1, 3, 2}));
}

TEST(PairSweepsT4, OtherPatternsPairByElevationAlone)
{
  const PolarVolume before = VolumeOf({{1, 0.5}, {3, 1.45}, {5, 3.4}});
  const PolarVolume after = VolumeOf({{1, 0.5}, {3, 0.9}, {5, 1.3}, {7, 1.8}, {8, 3.0}});
  EXPECT_EQ(PairSweeps(before, after), (Pairs{0, 2, std::nullopt}));
}

TEST(PairSweepsT4, ASweepWithoutRaysIsNoPartner)
{
  PolarVolume after = VolumeOf({{1, 0.0}});
  after.sweeps[0].rays.clear();
  EXPECT_EQ(PairSweeps(VolumeOf({{1, 0.1}}), after), (Pairs{std::nullopt}));
}

TEST(RayFinderT4, FindsTheNearestRayAlsoAcrossNorth)
{
  NumberSweep sweep = MakeSweep(1, 0.5, 360, 1); // rays at 0°, 1°, … 359°
  const RayFinder finder(sweep);
  EXPECT_EQ(finder.Nearest(10.4, 0.95), 10u);
  EXPECT_EQ(finder.Nearest(10.6, 0.95), 11u);
  EXPECT_EQ(finder.Nearest(359.7, 0.95), 0u);
  EXPECT_EQ(finder.Nearest(-0.7, 0.95), 359u);
  EXPECT_EQ(finder.Nearest(359.4, 0.95), 359u);
}

TEST(RayFinderT4, NothingBeyondTheTolerance)
{
  const NumberSweep sweep = MakeSweep(1, 0.5, 4, 1); // 0°, 90°, 180°, 270°
  const RayFinder finder(sweep);
  EXPECT_EQ(finder.Nearest(90.9, 0.95), 1u);
  EXPECT_FALSE(finder.Nearest(91.0, 0.95));
  EXPECT_FALSE(RayFinder(PolarSweep{}).Nearest(0.0, 360.0));
}

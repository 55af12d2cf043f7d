// SPDX-License-Identifier: BSD-3-Clause
// What a volume holds above each place, and where something may move from or to.
#include "BeamScene.h"
#include "Tolerance.h"
#include "nexrad/Beams/BeamVolume.h"
#include "nexrad/Beams/VolumeComposite.h"
#include "nexrad/Geometry/Angles.h"
#include "nexrad/Gridding/EchoMask.h"

#include <gtest/gtest.h>

using namespace nexrad;
using namespace nexrad::testing;

namespace
{

using Cell = VolumeComposite::Cell;

VolumeComposite CompositeOf(const std::vector<NumberSweep>& sweeps)
{
  return PrepareBeamVolume(VolumeOf(sweeps)).composite;
}

} // namespace

TEST(VolumeComposite, HoldsTheStrongestEchoOfEachCell)
{
  NumberSweep low = MakeSweep(1, 0.5, 360, 230);
  NumberSweep high = MakeSweep(2, 2.4, 360, 230);
  SetGate(low, 90, 60, 30.0F); // 61 km east
  SetGate(high, 90, 60, 42.0F);
  SetGate(low, 90, 62, -10.0F); // 63 km
  const VolumeComposite composite = CompositeOf({low, high});
  EXPECT_EQ(composite.rings, 116); // 230.5 km
  EXPECT_NEAR(composite.values[composite.Index(90, 30)], 42.0F, 0.01F);
  EXPECT_EQ(composite.cells[composite.Index(90, 31)], Cell::Held);
  EXPECT_EQ(composite.values[composite.Index(90, 31)], 0.0F);
  EXPECT_EQ(composite.cells[composite.Index(93, 30)], Cell::NoEcho);
  EXPECT_EQ(composite.cells[composite.Index(90, 114)], Cell::NoEcho);
}

// An empty composite was indexed.
TEST(VolumeComposite, ASweepThatEndsBehindTheAntennaIsLeftOut)
{
  NumberSweep behind = MakeSweep(1, 0.5, 360, 4, 250.0);
  behind.firstGate = -2'000.0;
  SetAll(behind, 30.0F);
  EXPECT_TRUE(PrepareBeamVolume(VolumeOf({behind})).sweeps.empty());
  EXPECT_EQ(CompositeOf({behind}).rings, 0);
  EXPECT_EQ(CompositeOf({behind, MakeSweep(2, 0.5, 360, 230)}).rings, 116);
  BeamSweep empty;
  empty.gatesPerMetre = 1.0F / 250.0F;
  empty.azimuths = {-1.0F, 0.0F, 1.0F};
  EXPECT_EQ(MakeComposite({empty}).rings, 0);
}

TEST(VolumeComposite, ASweepStraightUpHasARing)
{
  NumberSweep up = MakeSweep(1, 90.0, 360, 40);
  SetAll(up, 30.0F);
  const VolumeComposite composite = CompositeOf({up});
  ASSERT_EQ(composite.rings, 1);
  EXPECT_EQ(composite.cells[0], Cell::Held);
}

TEST(VolumeComposite, HoldsRaysOfHalfADegreeAndOfTwo)
{
  for (const std::size_t rays : {std::size_t(720), std::size_t(180)})
  {
    NumberSweep sweep = MakeSweep(1, 0.5, rays, 100);
    for (std::size_t ray = 0; ray < rays; ++ray)
    {
      SetGate(sweep, ray, 50, 20.0F);
    }
    const VolumeComposite composite = CompositeOf({sweep});
    for (int sector = 0; sector < VolumeComposite::Sectors; ++sector)
    {
      ASSERT_NEAR(composite.values[composite.Index(sector, 25)], 20.0F, 0.01F) << sector;
      ASSERT_EQ(composite.cells[composite.Index(sector, 24)], Cell::NoEcho) << sector;
    }
  }
}

TEST(VolumeComposite, KnowsWhatWasNotScannedAndWhatIsFolded)
{
  NumberSweep sweep = MakeSweep(1, 0.5, 360, 100);
  sweep.states[sweep.Index(10, 50)] = GateState::RangeFolded;
  sweep.rays.resize(180);
  sweep.values.resize(sweep.gates * 180);
  sweep.states.resize(sweep.gates * 180);
  const VolumeComposite composite = CompositeOf({sweep});
  EXPECT_EQ(composite.cells[composite.Index(10, 25)], Cell::Held);
  EXPECT_EQ(composite.values[composite.Index(10, 25)], 0.0F);
  EXPECT_EQ(composite.cells[composite.Index(100, 25)], Cell::NoEcho);
  EXPECT_EQ(composite.cells[composite.Index(250, 25)], Cell::NotScanned);
  EXPECT_EQ(composite.echo, 0.0);
}

// 30 dBZ seen at second 0 and 10 dBZ at second 100: the mean time is 25 s.
TEST(VolumeComposite, WeighsTheTimeByTheEcho)
{
  NumberSweep low = UniformSweep(1, 0.5, 30.0F, 0.0);
  NumberSweep high = UniformSweep(2, 0.9, 10.0F, 100.0);
  const VolumeComposite composite = CompositeOf({low, high});
  EXPECT_NEAR(composite.echoTime - ToSeconds(sceneTime), 25.0, 1e-3);
}

// Echo at 60 km in the direction 300°, on the two lower of three tilts: wherever a look within the
// distance of a column could meet it, the mask has the tilt; far from it, it has none.
TEST(EchoMask, HoldsWhatMayReachAColumn)
{
  NumberSweep low = MakeSweep(1, 0.5, 360, 230);
  NumberSweep middle = MakeSweep(2, 2.4, 360, 230);
  const NumberSweep high = MakeSweep(3, 19.5, 360, 70);
  SetGate(low, 300, 59, 30.0F);
  SetGate(middle, 300, 59, 30.0F);
  const VolumeComposite composite = CompositeOf({low, middle, high});
  const double radius = BeamModel().EffectiveRadius();
  for (const double distance : {0.0, 4'000.0, 25'000.0, 80'000.0})
  {
    const EchoMask mask({&composite}, radius, distance);
    const double echoEast = 60e3 * std::sin(300.0 * RadiansPerDegree);
    const double echoNorth = 60e3 * std::cos(300.0 * RadiansPerDegree);
    std::size_t held = 0;
    std::size_t far = 0;
    for (double east = -200e3; east <= 200e3; east += 1'900.0)
    {
      for (double north = -200e3; north <= 200e3; north += 1'900.0)
      {
        const double azimuth = std::atan2(east, north) / RadiansPerDegree;
        const ColumnDirection column = {
          static_cast<float>(azimuth < 0.0 ? azimuth + 360.0 : azimuth),
          static_cast<float>(std::tan(0.5 * std::hypot(east, north) / radius))};
        const double way = std::hypot(east - echoEast, north - echoNorth);
        if (way <= distance + 1'500.0) // the gate's own reach, and the ray's
        {
          ++held;
          ASSERT_EQ(mask.TopOver(column), ElevationCode(2.4F))
            << east << ' ' << north << ' ' << distance;
        }
        else if (way > 2.0 * distance + 90e3)
        {
          ++far;
          ASSERT_EQ(mask.TopOver(column), 0) << east << ' ' << north << ' ' << distance;
        }
      }
    }
    EXPECT_GT(held, 0u);
    EXPECT_AT_LEAST(far, 2'100u, "columns far away");
  }
}

TEST(EchoMask, ElevationsHaveCodesInTheirOrder)
{
  EXPECT_GT(ElevationCode(-10.0F), 0);
  for (float elevation = -10.0F; elevation < 90.0F; elevation += 0.05F)
  {
    EXPECT_LE(ElevationCode(elevation), ElevationCode(elevation + 0.05F));
  }
  EXPECT_LT(ElevationCode(19.0F), ElevationCode(19.6F));
  EXPECT_LT(ElevationCode(0.5F), ElevationCode(1.4F));
}

TEST(EchoMask, TellsNothingWhenEmpty)
{
  EXPECT_EQ(EchoMask().TopOver({12.0F, 0.01F}), 255);
}

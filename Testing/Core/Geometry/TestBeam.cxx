// SPDX-License-Identifier: BSD-3-Clause
#include "Tolerance.h"
#include "nexrad/Geometry/Beam.h"

#include "nexrad/System/Error.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

using namespace nexrad;

// Formulas B1 by hand, 0.5° at 230 km: a_e = 8 494 667 m, r·sin θ = 2007.1 m. In parabolic form
// h = r·sin θ + (r·cos θ)²/(2·a_e) = 2007.1 + 3113.5 = 5120.6 m, less (r·sin θ)·h/a_e = 1.2 m.
TEST(BeamB1, HeightAtTheEdgeOfRangeIsTheHandbooks)
{
  const BeamPoint point = BeamModel().Locate(230'000.0, 0.5);
  EXPECT_WITHIN(point.height, 5119.4, 0.24, "height of the handbook's beam, m");
  // s = a_e·atan(r·cos θ/(a_e + r·sin θ)) = a_e·atan(229 991.2/8 496 674.1) = a_e·0.02706178.
  EXPECT_WITHIN(
    point.groundDistance, 229'880.7, 0.15, "distance of the handbook's beam along the ground, m");
}

TEST(BeamB1, TheNexradRefractionBendsTheBeamLess)
{
  // k = 1.21: (r·cos θ)²/(2·1.21·a) = 3430.9 m in place of 3113.5 m.
  EXPECT_WITHIN(BeamModel(1.21).Locate(230'000.0, 0.5).height, 2007.1 + 3430.9 - 1.4, 0.5,
    "height of the beam at k = 1.21, m");
}

TEST(BeamB1, StraightUpIsStraightUp)
{
  const BeamPoint point = BeamModel().Locate(12'345.0, 90.0);
  EXPECT_NEAR(point.height, 12'345.0, 1e-6);
  EXPECT_NEAR(point.groundDistance, 0.0, 1e-6);
}

TEST(BeamB2, InvertsB1ToAMillimetre)
{
  const BeamModel beam;
  for (const double elevation : {-1.0, -0.2, 0.0, 0.48, 0.5, 1.45, 4.3, 19.5, 60.0, 89.9})
  {
    for (const double range : {1.0, 125.0, 2'125.0, 50'000.0, 230'000.0, 460'000.0})
    {
      const BeamDirection back = beam.Look(beam.Locate(range, elevation));
      EXPECT_NEAR(back.slantRange, range, 1e-3) << elevation << " degrees";
      EXPECT_NEAR(back.elevation, elevation, 1e-8) << range << " m";
    }
  }
}

TEST(BeamB2, HeightOverIsB1AtThatDistance)
{
  const BeamModel beam;
  for (const double elevation : {-0.5, 0.0, 0.5, 6.0, 19.5, 60.0})
  {
    for (const double range : {250.0, 50'000.0, 230'000.0})
    {
      const BeamPoint point = beam.Locate(range, elevation);
      EXPECT_NEAR(beam.HeightOver(point.groundDistance, elevation), point.height, 1e-4);
    }
  }
  EXPECT_EQ(beam.HeightOver(100'000.0, 90.0), std::numeric_limits<double>::infinity());
}

TEST(BeamB1, DistanceAtIsWhereTheBeamReachesTheHeight)
{
  const BeamModel beam;
  for (const double elevation : {0.0, 0.5, 6.0, 19.5, 60.0, 90.0})
  {
    for (const double range : {250.0, 50'000.0, 230'000.0})
    {
      const BeamPoint point = beam.Locate(range, elevation);
      EXPECT_NEAR(beam.DistanceAt(point.height, elevation), point.groundDistance, 1e-3);
    }
  }
}

TEST(Beam, RefusesAnEarthWithoutRadius)
{
  EXPECT_THROW(BeamModel(0.0), Error);
  EXPECT_THROW(BeamModel(-1.0), Error);
  EXPECT_THROW(BeamModel(std::numeric_limits<double>::infinity()), Error);
  EXPECT_THROW(BeamModel(std::nan("")), Error);
}

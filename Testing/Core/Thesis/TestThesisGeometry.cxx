// SPDX-License-Identifier: BSD-3-Clause
#include "Tolerance.h"
#include "nexrad/Grid/MakeGrid.h"
#include "nexrad/Thesis/ThesisGeometry.h"

#include "nexrad/Geometry/Beam.h"

#include <gtest/gtest.h>

#include <cmath>

using namespace nexrad;

namespace
{

const Position site = {38.81025, -94.26447, 330.0};

} // namespace

// T2 by hand, 0.5° at 230 km from sea level: r·sin θ = 2007.1 m, (r·cos θ)²/(2·(Re + r·sin θ)) =
// 4152.3 m: together 6159.5 m, less 1.3 m of the next term. Refraction makes it 5119 m (B1).
TEST(ThesisT2, PlacesTheFarBeamAKilometreTooHigh)
{
  const ThesisPoint point = ThesisRay(0.0, 0.5, 0.0).Locate(230'000.0);
  EXPECT_WITHIN(point.altitude, 6'159.5, 2.5, "altitude of the thesis's far beam, m");
  EXPECT_WITHIN(point.altitude - BeamModel().Locate(230'000.0, 0.5).height, 1'039.0, 0.4,
    "thesis's beam above the handbook's, m");
}

TEST(ThesisT2, StartsAtTheAntenna)
{
  const ThesisPoint point = ThesisRay(123.0, 4.0, 330.0).Locate(0.0);
  EXPECT_NEAR(point.altitude, 330.0, 1e-6);
  EXPECT_DOUBLE_EQ(point.east, 0.0);
  EXPECT_DOUBLE_EQ(point.north, 0.0);
}

TEST(ThesisT1, AzimuthTurnsClockwiseFromNorth)
{
  const ThesisPoint east = ThesisRay(90.0, 0.0, 0.0).Locate(1'000.0);
  EXPECT_NEAR(east.east, 1'000.0, 1e-9);
  EXPECT_NEAR(east.north, 0.0, 1e-9);
  const ThesisPoint southWest = ThesisRay(225.0, 60.0, 0.0).Locate(1'000.0);
  EXPECT_NEAR(southWest.east, -500.0 * std::sqrt(0.5), 1e-9);
  EXPECT_NEAR(southWest.north, -500.0 * std::sqrt(0.5), 1e-9);
}

// A degree of latitude is π·6 367 450/180 = 111 133.0 m; of longitude, cos(60°) = ½ of it.
TEST(ThesisT1, DegreesFollowTheScales)
{
  const auto place = ThesisGeographic({60.0, 10.0, 0.0}, 55'566.5, 111'133.0);
  EXPECT_NEAR(place[0], 11.0, 1e-5);
  EXPECT_NEAR(place[1], 61.0, 1e-5);
}

// By hand: 3 × 2 × 4 cells of 1° × 2° × 500 m from 9° east, 59° north, 0 m. A place of 10.5° east,
// 61.5° north and 1600 m lies in cell (1, 1, 3): 1 + 3·(1 + 2·3) = 22.
TEST(ThesisT3, IndexIsTheFractionOfTheBoxRoundedDown)
{
  GridRequest request;
  request.axes = GridAxes::Geographic;
  request.bounds = GeographicBounds{9.0, 59.0, 12.0, 63.0};
  request.dimensions = {3, 2, 4};
  request.bottom = 0.0;
  request.top = 2'000.0;
  const GridSpecification grid = MakeGrid(request, {});
  const ThesisCells cells(grid, {60.0, 10.0, 0.0}, 400'000.0);
  const double degreeNorth = 111'132.97;
  const double degreeEast = 0.5 * degreeNorth;
  EXPECT_EQ(cells.Find({0.5 * degreeEast, 1.5 * degreeNorth, 1'600.0}), 22);
  EXPECT_EQ(cells.Find({-0.01 * degreeEast, 0.0, 0.0}), 0);
  EXPECT_EQ(cells.Find({0.01 * degreeEast, 0.0, 499.99}), 1);
  EXPECT_EQ(cells.Find({0.01 * degreeEast, 0.0, 500.0}), 7) << "a face belongs to the cell above";
  EXPECT_EQ(cells.Find({0.0, 0.0, -0.01}), -1);
  EXPECT_EQ(cells.Find({0.0, 0.0, 2'000.0}), -1);
  EXPECT_EQ(cells.Find({-1.01 * degreeEast, 0.0, 100.0}), -1);
  EXPECT_EQ(cells.Find({0.0, 3.01 * degreeNorth, 100.0}), -1);
}

// The lattice against the exact projection of T1's longitude and latitude.
TEST(ThesisT3, LatticeFollowsTheProjectionWithinFiveMetres)
{
  for (const double latitude : {25.0, 38.8, 48.5, 65.0})
  {
    const Position place = {latitude, -94.3, 300.0};
    const GridSpecification grid = MakeGrid({}, {place, {latitude - 1.0, -90.0, 200.0}});
    const ThesisCells cells(grid, place, 460'000.0);
    double worst = 0.0;
    for (double azimuth = 0.5; azimuth < 360.0; azimuth += 7.0)
    {
      for (double range = 500.0; range < 460'000.0; range += 3'777.0)
      {
        const ThesisPoint point = ThesisRay(azimuth, 0.5, 300.0).Locate(range);
        const auto geographic = ThesisGeographic(place, point.east, point.north);
        const auto exact = grid.FromGeographic(geographic[0], geographic[1]);
        const auto cell = cells.CellCoordinates(point.east, point.north);
        const double x = grid.origin[0] + (cell[0] - 0.5) * grid.spacing[0];
        const double y = grid.origin[1] + (cell[1] - 0.5) * grid.spacing[1];
        worst = std::max(worst, std::hypot(x - exact[0], y - exact[1]));
      }
    }
    EXPECT_AT_MOST(worst, 2.3, "error of the lattice, m") << "at latitude " << latitude;
  }
}

TEST(ThesisT3, BeyondTheRadiusIsNoCell)
{
  const GridSpecification grid = MakeGrid({}, {site});
  const ThesisCells cells(grid, site, 100'000.0);
  EXPECT_GE(cells.Find({99'000.0, 0.0, 5'000.0}), 0);
  EXPECT_EQ(cells.Find({101'000.0, 0.0, 5'000.0}), -1);
  EXPECT_EQ(cells.Find({std::nan(""), 0.0, 5'000.0}), -1);
  EXPECT_EQ(cells.Find({0.0, 0.0, std::nan("")}), -1);
}

// A position read from a damaged file may be anything; the cells must only be wrong, not fatal.
TEST(ThesisT3, SurvivesAPositionAtThePole)
{
  const GridSpecification grid = MakeGrid({}, {site});
  const ThesisCells cells(grid, {90.0, 0.0, 0.0}, 1e12);
  EXPECT_EQ(cells.Find({1'000.0, 1'000.0, 1'000.0}), -1);
}

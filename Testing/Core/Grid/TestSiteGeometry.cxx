// SPDX-License-Identifier: BSD-3-Clause
#include "Tolerance.h"
#include "nexrad/Grid/MakeGrid.h"
#include "nexrad/Grid/SiteGeometry.h"

#include "nexrad/Geometry/Angles.h"
#include "nexrad/Geometry/SiteGeoreference.h"

#include <gtest/gtest.h>

#include <cmath>

using namespace nexrad;

namespace
{

const Position keax = {38.81, -94.264, 333.0};
const Position klsx = {38.699, -90.683, 220.0};

// Largest horizontal distance between a column and where the geometry has it, m, over every
// seventh column in the box.
double LargestError(const GridSpecification& grid, const Position& site, double reach)
{
  const SiteGeometry geometry(grid, site, reach);
  const SiteGeoreference exact(site);
  const double radius = BeamModel().EffectiveRadius();
  double largest = 0.0;
  for (int y = geometry.BeginY(); y < geometry.EndY(); y += 7)
  {
    for (int x = geometry.BeginX(); x < geometry.EndX(); x += 7)
    {
      const auto place = grid.ToGeographic(grid.Coordinate(0, x), grid.Coordinate(1, y));
      const GroundDirection wanted = exact.Look(place[0], place[1]);
      const ColumnDirection& got = geometry.Row(y)[x - geometry.BeginX()];
      const double distance = 2.0 * radius * std::atan(static_cast<double>(got.halfTangent));
      const double turn = distance < SiteGeometry::FarthestGate
                            ? AngleDifference(wanted.azimuth, static_cast<double>(got.azimuth))
                            : static_cast<double>(got.azimuth);
      largest = std::max(largest, std::hypot(distance - wanted.groundDistance,
                                    turn * RadiansPerDegree * wanted.groundDistance));
    }
  }
  return largest;
}

GridSpecification GridAbout(const std::vector<Position>& sites, GridAxes axes)
{
  GridRequest request;
  request.axes = axes;
  return MakeGrid(request, sites);
}

} // namespace

TEST(SiteGeometry, IsWithinFiveMetresOfTheGeodesics)
{
  EXPECT_AT_MOST(LargestError(GridAbout({keax, klsx}, GridAxes::Projected), keax, 480'000.0), 0.17,
    "error of the distance in the projection, m");
  EXPECT_AT_MOST(LargestError(GridAbout({keax, klsx}, GridAxes::Geographic), klsx, 480'000.0), 2.5,
    "error of the distance on geographic axes, m");
  const Position barrow = {70.0, -156.0, 10.0};
  EXPECT_AT_MOST(LargestError(GridAbout({barrow}, GridAxes::Projected), barrow, 480'000.0), 0.15,
    "error of the distance in the projection near the pole, m");
  EXPECT_AT_MOST(LargestError(GridAbout({barrow}, GridAxes::Geographic), barrow, 480'000.0), 1.6,
    "error of the distance on geographic axes near the pole, m");
}

TEST(SiteGeometry, KeepsTheColumnsInReachAndNotAContinent)
{
  GridSpecification grid;
  grid.dimensions = {500, 300, 1};
  grid.spacing = {10'000.0, 10'000.0, 1.0};
  grid.origin = {-2'495'000.0, -1'495'000.0, 0.0};
  grid.centreLatitude = 39.0;
  grid.centreLongitude = -98.0;
  const Position portland = {43.891, -70.257, 125.0}; // far from the projection's centre
  const SiteGeometry geometry(grid, portland, 300'000.0);
  EXPECT_AT_MOST(geometry.EndX() - geometry.BeginX(), 75, "columns in reach along x");
  const SiteGeoreference exact(portland);
  for (int y = 0; y < 300; y += 3)
  {
    for (int x = 0; x < 500; x += 3)
    {
      const auto place = grid.ToGeographic(grid.Coordinate(0, x), grid.Coordinate(1, y));
      if (exact.Look(place[0], place[1]).groundDistance < 300'000.0)
      {
        EXPECT_TRUE(x >= geometry.BeginX() && x < geometry.EndX());
        EXPECT_TRUE(y >= geometry.BeginY() && y < geometry.EndY());
      }
    }
  }
}

TEST(SiteGeometry, IsEmptyForASiteFarFromTheGrid)
{
  const SiteGeometry geometry(
    GridAbout({keax}, GridAxes::Projected), {48.0, -122.0, 0.0}, 480'000.0);
  EXPECT_EQ(geometry.BeginX(), geometry.EndX());
}

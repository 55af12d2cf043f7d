// SPDX-License-Identifier: BSD-3-Clause
#include "ErrorMessage.h"
#include "Tolerance.h"
#include "nexrad/Grid/MakeGrid.h"

#include "nexrad/Geometry/SiteGeoreference.h"
#include "nexrad/Grid/GridSpecification.h"
#include "nexrad/System/Error.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <string>

using namespace nexrad;
using nexrad::testing::MessageOf;

namespace
{

const std::vector<Position> threeSites = {{38.81025, -94.26447, 330.0}, // KEAX
  {40.15050, -89.33683, 201.0},                                         // KILX
  {38.69889, -90.68278, 206.0}};                                        // KLSX

double LowerFace(const GridSpecification& grid, std::size_t axis)
{
  return grid.origin[axis] - 0.5 * grid.spacing[axis];
}

double UpperFace(const GridSpecification& grid, std::size_t axis)
{
  return LowerFace(grid, axis) + grid.spacing[axis] * grid.dimensions[axis];
}

// How far the circles about the sites stay inside the faces: smallest distance to the west, south,
// east and north face, in units of the axes. Negative: a circle sticks out.
std::array<double, 4> Margins(
  const GridSpecification& grid, const std::vector<Position>& sites, double range)
{
  std::array<double, 4> margins = {1e9, 1e9, 1e9, 1e9};
  for (const Position& site : sites)
  {
    for (double azimuth = 0.0; azimuth < 360.0; azimuth += 0.1)
    {
      const auto place = SiteGeoreference(site).Locate({azimuth, range});
      const auto point = grid.FromGeographic(place[0], place[1]);
      margins[0] = std::min(margins[0], point[0] - LowerFace(grid, 0));
      margins[1] = std::min(margins[1], point[1] - LowerFace(grid, 1));
      margins[2] = std::min(margins[2], UpperFace(grid, 0) - point[0]);
      margins[3] = std::min(margins[3], UpperFace(grid, 1) - point[1]);
    }
  }
  return margins;
}

} // namespace

TEST(MakeGrid, BoxHoldsTheCirclesOfAllSitesAndNotMuchMore)
{
  const GridSpecification grid = MakeGrid({}, threeSites);
  for (const double margin : Margins(grid, threeSites, 230'000.0))
  {
    EXPECT_GE(margin, 0.0);
    EXPECT_AT_MOST(margin, 2.4, "margin about the circles, m") << "m; the faces are whole metres";
  }
  EXPECT_DOUBLE_EQ(LowerFace(grid, 2), 0.0);
  EXPECT_DOUBLE_EQ(UpperFace(grid, 2), 20'000.0);
}

// Whichever sites lie outermost: sites strewn over parts of the earth of all sizes.
TEST(MakeGrid, BoxHoldsTheCirclesOfManySites)
{
  std::mt19937 random(36);
  for (const double size : {0.2, 3.0, 30.0, 75.0}) // degrees, half of the part
  {
    std::uniform_real_distribution<double> offset(-size, size);
    const double latitude = std::min(45.0, 85.0 - size);
    std::vector<Position> sites;
    for (int i = 0; i < 25; ++i)
    {
      sites.push_back({latitude + offset(random), -100.0 + offset(random), 0.0});
    }
    for (const double margin : Margins(MakeGrid({}, sites), sites, DefaultRange))
    {
      EXPECT_GE(margin, 0.0) << size;
      EXPECT_AT_MOST(margin, 2.0, "distance of the circles from a face of the box, m");
    }
  }
}

TEST(MakeGrid, ProjectionCentreIsTheBoxCentreRoundedToHundredths)
{
  const GridSpecification grid = MakeGrid({}, threeSites);
  EXPECT_NEAR(grid.centreLatitude * 100.0, std::round(grid.centreLatitude * 100.0), 1e-9);
  EXPECT_NEAR(grid.centreLongitude * 100.0, std::round(grid.centreLongitude * 100.0), 1e-9);
  const auto middle = grid.ToGeographic(0.5 * (LowerFace(grid, 0) + UpperFace(grid, 0)),
    0.5 * (LowerFace(grid, 1) + UpperFace(grid, 1)));
  EXPECT_NEAR(middle[0], grid.centreLongitude, 0.0051);
  EXPECT_NEAR(middle[1], grid.centreLatitude, 0.0051);
}

TEST(MakeGrid, OneSiteLiesWithinHalfAHundredthOfTheCentre)
{
  const GridSpecification grid = MakeGrid({}, {threeSites[0]});
  EXPECT_NEAR(grid.centreLatitude, 38.81, 1e-9);
  EXPECT_NEAR(grid.centreLongitude, -94.26, 1e-9);
  EXPECT_WITHIN(grid.spacing[0] * grid.dimensions[0], 460'000.0, 3.0, "width of the grid, m");
}

TEST(MakeGrid, OriginIsTheLowerFacePlusHalfASpacing)
{
  GridRequest request;
  request.dimensions = {4, 2, 10};
  request.axes = GridAxes::Geographic;
  request.bounds = GeographicBounds{-96.0, 36.0, -88.0, 42.0};
  request.bottom = 500.0;
  request.top = 10'500.0;
  const GridSpecification grid = MakeGrid(request, {});
  EXPECT_DOUBLE_EQ(grid.origin[0], -95.0);
  EXPECT_DOUBLE_EQ(grid.origin[1], 37.5);
  EXPECT_DOUBLE_EQ(grid.origin[2], 1'000.0);
  EXPECT_DOUBLE_EQ(grid.spacing[0], 2.0);
  EXPECT_DOUBLE_EQ(grid.spacing[1], 3.0);
  EXPECT_DOUBLE_EQ(grid.spacing[2], 1'000.0);
  EXPECT_DOUBLE_EQ(grid.Coordinate(0, 3), -89.0);
  EXPECT_EQ(grid.VoxelCount(), 80u);
  EXPECT_EQ(grid.Projection(), "+proj=longlat +datum=WGS84 +no_defs");
}

TEST(MakeGrid, ProjectedBoundsHoldTheGeographicBox)
{
  GridRequest request;
  request.bounds = GeographicBounds{-96.0, 36.0, -88.0, 42.0};
  const GridSpecification grid = MakeGrid(request, {});
  EXPECT_EQ(grid.Projection(), "+proj=aeqd +lat_0=39 +lon_0=-92 +datum=WGS84 +units=m +no_defs");
  // The south edge bows down to its ends' corners, the widest parallel is the southern one.
  EXPECT_WITHIN(LowerFace(grid, 0), grid.FromGeographic(-96.0, 36.0)[0], 1.0, "western face, m");
  EXPECT_WITHIN(LowerFace(grid, 1), grid.FromGeographic(-92.0, 36.0)[1], 1.0, "southern face, m");
  EXPECT_WITHIN(UpperFace(grid, 1), grid.FromGeographic(-88.0, 42.0)[1], 0.4, "northern face, m");
}

TEST(MakeGrid, GeographicBoxAboutSitesHoldsTheCircles)
{
  GridRequest request;
  request.axes = GridAxes::Geographic;
  const GridSpecification grid = MakeGrid(request, threeSites);
  for (const double margin : Margins(grid, threeSites, 230'000.0))
  {
    EXPECT_GE(margin, 0.0);
    EXPECT_AT_MOST(margin, 1.4e-5, "margin about the circles, degrees") << "degrees";
  }
}

TEST(MakeGrid, CrossesTheAntimeridian)
{
  const std::vector<Position> sites = {{52.0, 179.5, 0.0}, {52.0, -179.0, 0.0}};
  for (const GridAxes axes : {GridAxes::Projected, GridAxes::Geographic})
  {
    GridRequest request;
    request.axes = axes;
    const GridSpecification grid = MakeGrid(request, sites);
    for (const double margin : Margins(grid, sites, 230'000.0))
    {
      EXPECT_GE(margin, 0.0);
    }
    const double width = UpperFace(grid, 0) - LowerFace(grid, 0);
    EXPECT_LT(width, axes == GridAxes::Projected ? 600'000.0 : 10.0);
    const auto place = grid.ToGeographic(grid.Coordinate(0, 200), grid.Coordinate(1, 100));
    EXPECT_NEAR(grid.FromGeographic(place[0], place[1])[0], grid.Coordinate(0, 200), 1e-6);
    EXPECT_LE(std::abs(place[0]), 180.0);
  }
}

TEST(MakeGrid, RefusesWhatIsNoGrid)
{
  const auto refuses = [](const GridRequest& request, const std::vector<Position>& sites)
  { EXPECT_THROW(MakeGrid(request, sites), Error); };
  refuses({}, {});
  GridRequest request;
  request.dimensions = {256, 0, 128};
  refuses(request, threeSites);
  request.dimensions = {2048, 2048, 512}; // 2³¹: one more than an int counts
  refuses(request, threeSites);
  request = {};
  request.range = 0.0;
  refuses(request, threeSites);
  request.range = std::nan("");
  refuses(request, threeSites);
  request = {};
  request.bottom = request.top;
  refuses(request, threeSites);
  request = {};
  request.bounds = GeographicBounds{-88.0, 36.0, -96.0, 42.0};
  refuses(request, threeSites);
  request.bounds = GeographicBounds{-96.0, 42.0, -88.0, 36.0};
  refuses(request, threeSites);
  request.bounds = GeographicBounds{-96.0, 36.0, std::nan(""), 42.0};
  refuses(request, threeSites);
}

// On a grid in metres the far side of the Earth has no place; on one in degrees it has.
TEST(MakeGrid, RefusesMoreThanHalfTheEarthInMetres)
{
  GridRequest request;
  request.bounds = GeographicBounds{-180.0, -90.0, 180.0, 90.0};
  const std::string error = MessageOf([&] { MakeGrid(request, threeSites); });
  EXPECT_NE(error.find("at most 180 degrees wide"), std::string::npos) << error;
  request.axes = GridAxes::Geographic;
  EXPECT_NO_THROW(MakeGrid(request, threeSites));
  request.axes = GridAxes::Projected;
  request.bounds = GeographicBounds{-90.0, -90.0, 90.0, 90.0};
  EXPECT_NO_THROW(MakeGrid(request, threeSites));
}

TEST(GridSpecification, GridTextNamesVoxelsAndCentre)
{
  GridSpecification grid;
  grid.dimensions = {64, 32, 8};
  grid.spacing = {1000.0, 2000.0, 2500.0};
  grid.centreLatitude = 38.5;
  grid.centreLongitude = -94.25;
  EXPECT_EQ(GridText(grid), "64x32x8 voxels of 1000 x 2000 x 2500 m about 38.5, -94.25");
  grid.axes = GridAxes::Geographic;
  grid.spacing = {0.25, 0.5, 500.0};
  EXPECT_EQ(GridText(grid), "64x32x8 voxels of 0.25 x 0.5 degrees x 500 m");
}

TEST(GridSpecification, ProjectionIsEquidistantFromItsCentre)
{
  GridSpecification grid;
  grid.centreLatitude = 38.7;
  grid.centreLongitude = -91.3;
  const SiteGeoreference centre({38.7, -91.3, 0.0});
  for (const double azimuth : {0.0, 45.0, 200.0})
  {
    const auto place = centre.Locate({azimuth, 300'000.0});
    const auto point = grid.FromGeographic(place[0], place[1]);
    EXPECT_NEAR(std::hypot(point[0], point[1]), 300'000.0, 1e-4);
    const auto back = grid.ToGeographic(point[0], point[1]);
    EXPECT_NEAR(back[0], place[0], 1e-10);
    EXPECT_NEAR(back[1], place[1], 1e-10);
  }
}

TEST(PlaceUnit, PlacesAreInTheUnitOfTheirVolume)
{
  EXPECT_EQ(PlaceUnitOf(GridAxes::Projected), PlaceUnit::Metres);
  EXPECT_EQ(PlaceUnitOf(GridAxes::Geographic), PlaceUnit::Degrees);
  for (const PlaceUnit unit : {PlaceUnit::Metres, PlaceUnit::Degrees})
  {
    EXPECT_NO_THROW(CheckPlaceUnit(PlaceUnit::OfVolume, unit, "it is"));
    EXPECT_NO_THROW(CheckPlaceUnit(unit, unit, "it is"));
  }
  EXPECT_THROW(CheckPlaceUnit(PlaceUnit::Metres, PlaceUnit::Degrees, "it is"), Error);
  EXPECT_THROW(CheckPlaceUnit(PlaceUnit::Degrees, PlaceUnit::Metres, "it is"), Error);
}

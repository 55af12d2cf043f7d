// SPDX-License-Identifier: BSD-3-Clause
#include "Tolerance.h"

#include "nexrad/Geometry/Beam.h"
#include "nexrad/Geometry/SiteGeoreference.h"
#include "nexrad/Grid/SiteGeometry.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

using namespace nexrad;

namespace
{

GridSpecification MakeWideGrid()
{
  GridSpecification grid;
  grid.dimensions = {25, 21, 6};
  grid.origin = {-360'000.0, -300'000.0, 250.0};
  grid.spacing = {30'000.0, 30'000.0, 3'500.0};
  grid.centreLatitude = 39.2;
  grid.centreLongitude = -92.4;
  return grid;
}

const Position radar = {38.699, -90.683, 185.5};

} // namespace

// Along the beam in the direction of a voxel, at its slant range, the beam is at the voxel's
// centre.
TEST(RadarView, TheBeamMeetsTheVoxel)
{
  const GridSpecification grid = MakeWideGrid();
  const RadarView view = MakeRadarView(grid, radar);
  const SiteGeoreference site(radar);
  const BeamModel beam;
  double across = 0.0;
  double above = 0.0;
  for (std::size_t voxel = 0; voxel < grid.VoxelCount(); ++voxel)
  {
    const auto x = static_cast<int>(voxel % 25);
    const auto y = static_cast<int>(voxel / 25 % 21);
    const auto z = static_cast<int>(voxel / 25 / 21);
    const BeamPoint point = beam.Locate(
      static_cast<double>(view.slantRange[voxel]), static_cast<double>(view.elevation[voxel]));
    const auto place =
      site.Locate({static_cast<double>(view.azimuth[voxel]), point.groundDistance});
    const auto met = grid.FromGeographic(place[0], place[1]);
    across =
      std::max(across, std::hypot(met[0] - grid.Coordinate(0, x), met[1] - grid.Coordinate(1, y)));
    above = std::max(above, std::abs(point.height + radar.altitude - grid.Coordinate(2, z)));
  }
  EXPECT_AT_MOST(across, 0.3, "Distance of the beam from a voxel of its view, along the ground, m");
  EXPECT_AT_MOST(above, 0.004, "Distance of the beam from a voxel of its view, in height, m");
}

TEST(RadarView, DirectionsAreThoseOfTheCompass)
{
  GridSpecification grid;
  grid.dimensions = {3, 3, 1};
  grid.origin = {-10'000.0, -10'000.0, radar.altitude};
  grid.spacing = {10'000.0, 10'000.0, 500.0};
  grid.centreLatitude = radar.latitude;
  grid.centreLongitude = radar.longitude;
  const RadarView view = MakeRadarView(grid, radar);
  EXPECT_NEAR(view.azimuth[1], 180.0, 1e-3); // south of the radar
  EXPECT_NEAR(view.azimuth[3], 270.0, 1e-3);
  EXPECT_NEAR(view.azimuth[5], 90.0, 1e-3);
  EXPECT_NEAR(std::remainder(view.azimuth[7], 360.0F), 0.0, 1e-3);
  EXPECT_NEAR(view.slantRange[5], 10'000.0, 1.0);
  EXPECT_EQ(view.slantRange[4], 0.0F);
  EXPECT_LT(view.elevation[5], 0.0F); // at the antenna's height 10 km away the beam looks down
}

TEST(RadarView, ThreadsChangeNothing)
{
  const GridSpecification grid = MakeWideGrid();
  const RadarView alone = MakeRadarView(grid, radar);
  const RadarView together = MakeRadarView(grid, radar, ThreadLoop(3));
  EXPECT_EQ(alone.azimuth, together.azimuth);
  EXPECT_EQ(alone.elevation, together.elevation);
  EXPECT_EQ(alone.slantRange, together.slantRange);
}

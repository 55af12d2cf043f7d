// SPDX-License-Identifier: BSD-3-Clause
#include "EventCounter.h"
#include "HandMadeVolume.h"
#include "SweepAccess.h"
#include "TestData.h"
#include "Tolerance.h"

#include "nexrad/Grid/GridSpecification.h"
#include "vtkNexradLevel2Reader.h"

#include "vtkErrorCode.h"
#include "vtkExecutive.h"
#include "vtkNew.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

namespace
{

using nexrad::testing::EventCounter;
using nexrad::testing::GridOf;

constexpr double latitude = 38.81;
constexpr double longitude = -94.264;
constexpr double altitude = 333.0;

/// Formulas B1, written out again: height above the antenna and distance along the ground.
std::array<double, 2> BeamByHand(double range, double elevation, double factor = 4.0 / 3.0)
{
  const double radius = factor * 6'371'000.0;
  const double angle = elevation * M_PI / 180.0;
  const double height =
    std::sqrt(range * range + radius * radius + 2.0 * range * radius * std::sin(angle)) - radius;
  return {height, radius * std::asin(range * std::cos(angle) / (radius + height))};
}

/// A sweep of four rays (north, east, south, west) at 0.5 degrees with a gate every 10 km.
class GateCoordinates : public ::testing::Test
{
protected:
  GateCoordinates()
  {
    nexrad::testing::HandMadeSweep sweep;
    sweep.rays = 4;
    sweep.firstAzimuth = 0.0;
    sweep.moments = {{nexrad::MomentName::REF, 47, 0, 10'000}};
    nexrad::testing::HandMadeVolume volume;
    volume.site = {"KEAX", nexrad::Position{latitude, longitude, altitude}};
    volume.start = *nexrad::ParseIso8601("2006-03-12T18:00:00Z");
    volume.sweeps = {sweep};
    reader->SetFileName(nexrad::testing::WriteLevel2(folder.Path() / "file", {volume}).c_str());
    // A message 31 file holds the position as 32-bit floats.
    reader->SetSitePosition(latitude, longitude, altitude);
    reader->UseSitePositionOn();
    events->Observe(reader);
  }

  std::array<double, 3> Point(int ray, int gate)
  {
    reader->Update();
    vtkStructuredGrid* grid = GridOf(reader->GetOutput(), 0);
    std::array<double, 3> point{};
    grid->GetPoint(ray * grid->GetDimensions()[0] + gate, point.data());
    return point;
  }

  const nexrad::testing::TemporaryFolder folder;
  vtkNew<vtkNexradLevel2Reader> reader;
  vtkNew<EventCounter> events;
};

TEST_F(GateCoordinates, LocalIsEastNorthAndUpOfTheAntenna)
{
  // 230 km at 0.5 degrees: 5119 m up and 229.78 km along the ground.
  const auto [height, ground] = BeamByHand(230'000.0, 0.5);
  EXPECT_WITHIN(height, 5119.0, 0.5, "height of the beam by hand, m");
  const auto north = this->Point(0, 23);
  EXPECT_NEAR(north[0], 0.0, 1e-6);
  EXPECT_NEAR(north[1], ground, 1e-6);
  // The encoder keeps angles to 32-bit floats; a thousandth of a degree is 4 m here.
  EXPECT_NEAR(north[2], height, 1e-6);
  const auto east = this->Point(1, 23);
  EXPECT_NEAR(east[0], ground, 1e-6);
  EXPECT_NEAR(east[1], 0.0, 1e-6);
  const auto south = this->Point(2, 23);
  EXPECT_NEAR(south[1], -ground, 1e-6);
  EXPECT_EQ(this->Point(3, 0)[0], 0.0); // the gate at the antenna
}

TEST_F(GateCoordinates, RefractionCanBeSet)
{
  reader->SetEffectiveRadiusFactor(1.21);
  const auto [height, ground] = BeamByHand(460'000.0, 0.5, 1.21);
  EXPECT_NEAR(this->Point(0, 46)[2], height, 1e-6);
  EXPECT_NEAR(this->Point(0, 46)[1], ground, 1e-6);
  EXPECT_AT_LEAST(
    height - BeamByHand(460'000.0, 0.5)[0], 900.0, "height that a weaker refraction adds, m");
}

TEST_F(GateCoordinates, GeographicIsTheGeodesicFromTheSite)
{
  reader->SetCoordinatesToGeographic();
  // Along the meridian: 230 km at 0.5 degrees by the meridian arc of WGS84,
  // M = a(1 − e²)/(1 − e² sin² φ)^(3/2) at the middle latitude 39.85°: 6 361 699 m.
  const auto [height, ground] = BeamByHand(230'000.0, 0.5);
  const auto north = this->Point(0, 23);
  EXPECT_NEAR(north[0], longitude, 1e-6);
  EXPECT_WITHIN(north[1], latitude + ground / 6'361'699.0 * 180.0 / M_PI, 2e-5,
    "latitude of the gate to the north, degrees");
  EXPECT_NEAR(north[2], altitude + height, 1e-6);
  // To the east a geodesic bends towards the equator.
  const auto east = this->Point(1, 46);
  EXPECT_AT_LEAST(east[0] - longitude, 5.0, "gate to the east, degrees of longitude");
  EXPECT_AT_LEAST(latitude - east[1], 0.1, "bend of the geodesic towards the equator, degrees");
}

// The cubics between the nodes against the geodesic of each gate.
TEST_F(GateCoordinates, EachGateIsWithinAMillimetreOfItsGeodesic)
{
  nexrad::GridSpecification about;
  about.centreLatitude = latitude;
  about.centreLongitude = longitude;
  for (int ray = 0; ray < 4; ++ray)
  {
    for (int gate = 0; gate < 47; ++gate)
    {
      reader->SetCoordinatesToLocal();
      const auto local = this->Point(ray, gate);
      reader->SetCoordinatesToGeographic();
      const auto placed = this->Point(ray, gate);
      const auto exact = about.ToGeographic(local[0], local[1]);
      EXPECT_NEAR(placed[0], exact[0], 1e-8) << ray << " " << gate;
      EXPECT_NEAR(placed[1], exact[1], 1e-8) << ray << " " << gate;
    }
  }
}

TEST_F(GateCoordinates, ProjectedIsThatOfAMergedVolume)
{
  nexrad::GridSpecification domain;
  domain.centreLatitude = 39.5;
  domain.centreLongitude = -92.0;
  nexrad::GridSpecification about;
  about.centreLatitude = latitude;
  about.centreLongitude = longitude;
  const auto local = this->Point(1, 30);
  reader->SetCoordinatesToProjected();
  reader->SetProjectionCenter(39.5, -92.0);
  reader->UseProjectionCenterOn();
  const auto projected = this->Point(1, 30);
  const auto place = about.ToGeographic(local[0], local[1]);
  const auto exact = domain.FromGeographic(place[0], place[1]);
  EXPECT_NEAR(projected[0], exact[0], 0.001);
  EXPECT_NEAR(projected[1], exact[1], 0.001);
  EXPECT_NEAR(projected[2], altitude + local[2], 0.001);
  // Without a centre it is the site, so that only the height differs from local.
  reader->UseProjectionCenterOff();
  EXPECT_NEAR(this->Point(1, 30)[0], local[0], 0.001);
  EXPECT_NEAR(this->Point(1, 30)[1], local[1], 0.001);
}

} // namespace

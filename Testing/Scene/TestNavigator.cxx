// SPDX-License-Identifier: BSD-3-Clause
// What is under a place of the picture, and how the camera moves about it.
#include "vtkNexradEchoPicker.h"
#include "vtkNexradNavigator.h"
#include "vtkNexradVolumeScene.h"

#include "ScenePicture.h"
#include "StormVolume.h"
#include "TestData.h"
#include "Tolerance.h"

#include <vtkCoordinate.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkRenderer.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <memory>
#include <string>

using namespace nexrad::testing;

namespace
{

constexpr std::array<int, 2> viewSize = {400, 300};
using ViewPoint = std::array<double, 2>;
using Place = std::array<double, 3>;

// The storm in a window, seen from the south west, where its tower stands.
class Navigator : public ::testing::Test
{
protected:
  void SetUp() override
  {
    UseClassicLook(scene);
    scene->SetVolume(MakeStormVolume(true));
    scene->SetTilt(25.0);
    window = std::make_unique<OffScreenWindow>(scene->GetRenderer(), viewSize);
    window->Draw();
    picker->SetScene(scene);
    navigator->SetScene(scene);
  }

  int Pick(const ViewPoint& pixel)
  {
    return picker->Pick(pixel[0], pixel[1], 0.0, scene->GetRenderer());
  }

  // Where VTK draws a point of the scene.
  ViewPoint PixelOf(const Place& point)
  {
    scene->Update();
    vtkNew<vtkCoordinate> coordinate;
    coordinate->SetCoordinateSystemToWorld();
    coordinate->SetValue(point[0], point[1], point[2]);
    const double* display = coordinate->GetComputedDoubleDisplayValue(scene->GetRenderer());
    return {display[0], display[1]};
  }

  Place Picked()
  {
    Place point{};
    picker->GetPickPosition(point.data());
    return point;
  }

  static double DistanceOf(const ViewPoint& a, const ViewPoint& b)
  {
    return std::hypot(a[0] - b[0], a[1] - b[1]);
  }

  vtkNew<vtkNexradVolumeScene> scene;
  vtkNew<vtkNexradEchoPicker> picker;
  vtkNew<vtkNexradNavigator> navigator;
  std::unique_ptr<OffScreenWindow> window;
};

// The tower stands 70 km west and south of 39° N 90° W.
ViewPoint Tower(vtkNexradVolumeScene* scene)
{
  vtkNew<vtkCoordinate> coordinate;
  coordinate->SetCoordinateSystemToWorld();
  coordinate->SetValue(-70.0, -70.0, 24.0); // 3 km, stretched 8 times
  const double* display = coordinate->GetComputedDoubleDisplayValue(scene->GetRenderer());
  return {display[0], display[1]};
}

} // namespace

TEST_F(Navigator, PicksTheEchoThatIsSeen)
{
  const ViewPoint pixel = Tower(scene);
  ASSERT_EQ(this->Pick(pixel), vtkNexradEchoPicker::ECHO);
  EXPECT_EQ(picker->GetArrayName(), "REF");
  EXPECT_EQ(picker->GetUnits(), "dBZ");
  EXPECT_AT_LEAST(picker->GetValue(), 25.0, "value of the echo that is seen at the tower, dBZ");
  EXPECT_AT_MOST(std::hypot(picker->GetLatitude() - 38.37, picker->GetLongitude() + 90.8), 0.45,
    "distance of the echo seen at the tower from its axis, degrees");
  EXPECT_NEAR(DistanceOf(this->PixelOf(this->Picked()), pixel), 0.0, 1e-6);
  EXPECT_EQ(picker->GetSiteName(), "KLSX");
  EXPECT_NE(picker->GetText().find(" dBZ (REF), 38."), std::string::npos) << picker->GetText();
}

TEST_F(Navigator, SaysTheValueInTheUnitOfTheColourTable)
{
  const TemporaryFolder folder;
  const std::filesystem::path table = folder.Path() / "knots.pal";
  std::ofstream(table) << "Units: KTS\nScale: 1.94384\nColor: 0 0 255 0\nColor: 140 255 0 0\n";
  scene->SetOption("colours", table.c_str());
  scene->Update();
  ASSERT_EQ(this->Pick(Tower(scene)), vtkNexradEchoPicker::ECHO);
  EXPECT_EQ(picker->GetUnits(), "dBZ");
  EXPECT_NEAR(std::stod(picker->GetText()), 1.94384 * picker->GetValue(), 0.06);
  EXPECT_NE(picker->GetText().find(" kt (REF), 38."), std::string::npos) << picker->GetText();
}

// KLSX lies at 38.6986° N 90.6828° W; half a pixel of this picture is a kilometre.
TEST_F(Navigator, PicksTheGroundWhereNoEchoIsSeen)
{
  scene->SetPreset("hail"); // the anvil is not seen
  scene->Update();
  const ViewPoint corner = this->PixelOf({150.0, -150.0, 0.0});
  ASSERT_EQ(this->Pick(corner), vtkNexradEchoPicker::GROUND);
  EXPECT_NEAR(picker->GetPlace()[0], 150e3, 1e-3);
  EXPECT_NEAR(picker->GetPlace()[1], -150e3, 1e-3);
  EXPECT_TRUE(std::isnan(picker->GetValue()));
  EXPECT_NE(picker->GetText().find("on the map"), std::string::npos) << picker->GetText();
  EXPECT_EQ(this->Pick({1.0, viewSize[1] - 1.0}), vtkNexradEchoPicker::NOTHING) << "the sky";
  EXPECT_EQ(picker->GetText(), "");
}

TEST_F(Navigator, LooksAtAPlace)
{
  scene->SetLookAtGeographic(38.6986, -90.6828, 2000.0);
  scene->SetZoom(4.0);
  ASSERT_TRUE(scene->Update());
  Place place{};
  ASSERT_TRUE(scene->GetLookAt(place.data()));
  const ViewPoint found = this->PixelOf({place[0] / 1000.0, place[1] / 1000.0, 8.0 * 2.0});
  EXPECT_NEAR(DistanceOf(found, {0.5 * viewSize[0], 0.5 * viewSize[1]}), 0.0, 1e-6);
  ASSERT_TRUE(scene->GetLookAtGeographic(place.data()));
  EXPECT_NEAR(place[0], 38.6986, 1e-6);
  EXPECT_NEAR(place[1], -90.6828, 1e-6);
  scene->LookAtDomain();
  EXPECT_FALSE(scene->GetLookAt(place.data()));
}

TEST_F(Navigator, CentresOnAnEchoAndTurnsAboutIt)
{
  ASSERT_EQ(navigator->CentreOn(Tower(scene)[0], Tower(scene)[1]), vtkNexradEchoPicker::ECHO);
  navigator->Zoom(3.0);
  scene->Update();
  Place place{};
  ASSERT_TRUE(scene->GetLookAt(place.data()));
  const Place pivot = {place[0] / 1000.0, place[1] / 1000.0, 8.0 * place[2] / 1000.0};
  const Place above = {pivot[0], pivot[1], pivot[2] + 20.0};
  const double height = DistanceOf(this->PixelOf(pivot), this->PixelOf(above));
  for (int i = 0; i < 4; ++i)
  {
    navigator->Turn(30.0, 0.0);
    EXPECT_NEAR(
      DistanceOf(this->PixelOf(pivot), {0.5 * viewSize[0], 0.5 * viewSize[1]}), 0.0, 1e-6);
    EXPECT_WITHIN(DistanceOf(this->PixelOf(pivot), this->PixelOf(above)) / height, 1.0, 0.003,
      "change of a height of 20 km where the camera turns, part");
  }
}

TEST_F(Navigator, ZoomsTowardsWhatIsThere)
{
  const ViewPoint pixel = Tower(scene);
  this->Pick(pixel);
  const Place point = this->Picked();
  for (int i = 0; i < 20; ++i)
  {
    navigator->ZoomAt(pixel[0], pixel[1], 1.1);
  }
  EXPECT_AT_MOST(DistanceOf(this->PixelOf(point), pixel), 1.1,
    "how far what is under the pointer moves in 20 steps of zoom, pixels");
  EXPECT_NEAR(scene->GetZoom(), std::pow(1.1, 20), 1e-6);
}

// The picture does not jump when the camera leaves the view of the whole domain.
TEST_F(Navigator, PansWhatItGrabbed)
{
  const Picture before = window->Draw();
  const ViewPoint pixel = Tower(scene);
  this->Pick(pixel);
  const Place point = this->Picked();
  navigator->Grab(pixel[0], pixel[1]);
  navigator->Pan(pixel[0], pixel[1]);
  EXPECT_EQ(MeanDifference(window->Draw(), before), 0.0);
  navigator->Pan(pixel[0] + 90.0, pixel[1] - 40.0);
  EXPECT_NEAR(DistanceOf(this->PixelOf(point), {pixel[0] + 90.0, pixel[1] - 40.0}), 0.0, 1e-6);
}

TEST_F(Navigator, RefusesLatitudeAndLongitudeWithoutAProjection)
{
  vtkNew<vtkImageData> bare;
  bare->SetDimensions(4, 4, 4);
  bare->AllocateScalars(VTK_FLOAT, 1);
  scene->SetVolume(bare);
  scene->SetLookAtGeographic(38.0, -90.0, 0.0);
  Place place{};
  EXPECT_FALSE(scene->GetLookAt(place.data()));
}

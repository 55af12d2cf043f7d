// SPDX-License-Identifier: BSD-3-Clause
#include "Scene/Frame/CameraView.h"
#include "Tolerance.h"

#include <vtkCamera.h>
#include <vtkMath.h>
#include <vtkMatrix4x4.h>
#include <vtkNew.h>
#include <vtkRenderer.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

using namespace nexrad::scene;

namespace
{

constexpr std::array<double, 6> box = {-300.0, 500.0, -200.0, 400.0, 0.0, 160.0};
constexpr double aspect = 16.0 / 9.0;

struct Picture
{
  double left = 1e9, right = -1e9, bottom = 1e9, top = -1e9;
};

std::array<double, 2> Project(vtkCamera* camera, double x, double y, double z)
{
  const double point[4] = {x, y, z, 1.0};
  double result[4];
  camera->GetCompositeProjectionTransformMatrix(aspect, -1.0, 1.0)->MultiplyPoint(point, result);
  EXPECT_GT(result[3], 0.0) << "behind the camera";
  return {result[0] / result[3], result[1] / result[3]};
}

// The rectangle of the picture, each side -1…1, that the box fills.
Picture Extent(vtkCamera* camera)
{
  Picture picture;
  for (int corner = 0; corner < 8; ++corner)
  {
    const auto [x, y] =
      Project(camera, box[corner & 1], box[2 + (corner >> 1 & 1)], box[4 + (corner >> 2)]);
    picture.left = std::min(picture.left, x);
    picture.right = std::max(picture.right, x);
    picture.bottom = std::min(picture.bottom, y);
    picture.top = std::max(picture.top, y);
  }
  return picture;
}

} // namespace

TEST(CameraView, TheBoxJustFitsTheAreaFromEverySide)
{
  const PictureArea area = {-0.9, 0.8, -0.7, 0.85};
  for (const bool parallel : {false, true})
  {
    for (double azimuth = 0.0; azimuth < 360.0; azimuth += 33.0)
    {
      for (const double tilt : {-20.0, 0.0, 35.0, 90.0})
      {
        vtkNew<vtkCamera> camera;
        PointCamera(camera, {azimuth, tilt, 1.0, parallel}, box, aspect, area);
        const Picture seen = Extent(camera);
        EXPECT_GE(seen.left, area.left - 1e-6);
        EXPECT_LE(seen.right, area.right + 1e-6);
        EXPECT_GE(seen.bottom, area.bottom - 1e-6);
        EXPECT_LE(seen.top, area.top + 1e-6);
        const bool fillsWidth = seen.right - seen.left > (area.right - area.left) * (1.0 - 1e-6);
        const bool fillsHeight = seen.top - seen.bottom > (area.top - area.bottom) * (1.0 - 1e-6);
        EXPECT_TRUE(fillsWidth || fillsHeight) << azimuth << ' ' << tilt << ' ' << parallel;
      }
    }
  }
}

TEST(CameraView, FromTheSouthEastIsOnTheRightAndNorthIsFar)
{
  vtkNew<vtkCamera> camera;
  PointCamera(camera, {180.0, 30.0, 1.0, false}, box, aspect, {});
  EXPECT_GT(Project(camera, 500.0, 0.0, 0.0)[0], Project(camera, -300.0, 0.0, 0.0)[0]);
  EXPECT_GT(Project(camera, 0.0, 400.0, 0.0)[1], Project(camera, 0.0, -200.0, 0.0)[1]);
  EXPECT_LT(camera->GetPosition()[1], -200.0);
  EXPECT_NEAR(RightOf({180.0, 30.0, 1.0, false})[0], 1.0, 1e-12);
}

TEST(CameraView, FromTheEastNorthIsOnTheRight)
{
  vtkNew<vtkCamera> camera;
  PointCamera(camera, {90.0, 30.0, 1.0, true}, box, aspect, {});
  EXPECT_GT(Project(camera, 0.0, 400.0, 0.0)[0], Project(camera, 0.0, -200.0, 0.0)[0]);
}

TEST(CameraView, ZoomOfTwoDoublesThePictureAboutItsCentre)
{
  for (const bool parallel : {false, true})
  {
    vtkNew<vtkCamera> once;
    vtkNew<vtkCamera> twice;
    PointCamera(once, {200.0, 35.0, 1.0, parallel}, box, aspect, {});
    PointCamera(twice, {200.0, 35.0, 2.0, parallel}, box, aspect, {});
    // A vtkCamera zooms by its angle of view, so that the factor holds near the centre.
    const auto before = Project(once, 110.0, 90.0, 60.0);
    const auto after = Project(twice, 110.0, 90.0, 60.0);
    EXPECT_WITHIN(after[0], 2.0 * before[0], 0.0045, "place across at twice the zoom, half widths");
    EXPECT_WITHIN(
      after[1], 2.0 * before[1], 0.0135, "place upwards at twice the zoom, half heights");
  }
}

// From the whole frame to a view: the picture grows, and what is looked at comes to its middle.
TEST(CameraView, AFlightEndsAtTheView)
{
  const std::array<double, 3> target = {310.0, 220.0, 40.0};
  for (const double zoom : {1.0, 12.0})
  {
    CameraView view{200.0, 35.0, zoom, false};
    view.lookAt = LookAt{target, false};
    EXPECT_TRUE(OnTheWayTo(view, 1.0) == view);
    EXPECT_EQ(OnTheWayTo(view, 0.0).zoom, 1.0);
    EXPECT_EQ(OnTheWayTo(view, 0.0).nearness, 0.0);
    double before = std::numeric_limits<double>::infinity();
    double zoomBefore = 1.0;
    for (const double part : {0.0, 0.2, 0.4, 0.6, 0.8, 1.0})
    {
      const CameraView there = OnTheWayTo(view, part);
      vtkNew<vtkCamera> camera;
      PointCamera(camera, there, box, aspect, {});
      CentreOn(camera, target, there.nearness);
      const auto [x, y] = Project(camera, target[0], target[1], target[2]);
      EXPECT_LT(std::hypot(x, y), before) << zoom << " " << part;
      EXPECT_GE(there.zoom, zoomBefore);
      before = std::hypot(x, y);
      zoomBefore = there.zoom;
    }
    EXPECT_NEAR(before, 0.0, 1e-9);
  }
}

// Which part of a box a picture shows, and how large its pixels are there.

namespace
{

constexpr std::array<int, 2> seenSize = {400, 200};
constexpr std::array<double, 6> seenBox = {-500.0, 500.0, -300.0, 300.0, 0.0, 20.0};

void SeeFrom(vtkRenderer* renderer, const std::array<double, 3>& position)
{
  vtkCamera* camera = renderer->GetActiveCamera();
  camera->SetPosition(position.data());
  camera->SetFocalPoint(10.0, -20.0, 5.0);
  camera->SetViewUp(0.0, 1.0, 0.0);
  camera->SetViewAngle(30.0);
}

// Whether the picture shows a point.
bool IsShown(vtkCamera* camera, const std::array<double, 3>& point)
{
  vtkMatrix4x4* matrix = camera->GetCompositeProjectionTransformMatrix(
    static_cast<double>(seenSize[0]) / seenSize[1], -1.0, 1.0);
  const double given[4] = {point[0], point[1], point[2], 1.0};
  double shown[4];
  matrix->MultiplyPoint(given, shown);
  return shown[3] > 0.0 && std::abs(shown[0]) <= shown[3] && std::abs(shown[1]) <= shown[3];
}

} // namespace

TEST(SeenPart, FromAboveIsThePicture)
{
  vtkNew<vtkRenderer> renderer;
  SeeFrom(renderer, {10.0, -20.0, 2000.0});
  renderer->GetActiveCamera()->SetParallelProjection(1);
  renderer->GetActiveCamera()->SetParallelScale(50.0); // half of the height
  const auto seen = FindSeen(renderer, seenSize, seenBox);
  ASSERT_TRUE(seen);
  EXPECT_NEAR(seen->pixel, 0.5, 1e-9);
  const std::array<double, 4> expected = {-90.0, 110.0, -70.0, 30.0};
  for (std::size_t side = 0; side < 4; ++side)
  {
    EXPECT_NEAR(seen->faces[side], expected[side], 1e-6) << side;
  }
}

TEST(SeenPart, EndsWithTheBox)
{
  vtkNew<vtkRenderer> renderer;
  SeeFrom(renderer, {10.0, -20.0, 20'000.0});
  const auto seen = FindSeen(renderer, seenSize, seenBox);
  ASSERT_TRUE(seen);
  EXPECT_EQ(seen->faces, (std::array<double, 4>{-500.0, 500.0, -300.0, 300.0}));
  EXPECT_NEAR(seen->pixel, 2.0 * (20'000.0 - 20.0) * std::tan(vtkMath::Pi() / 12.0) / 200.0, 1e-6);
}

TEST(SeenPart, BesideTheBoxIsNothing)
{
  vtkNew<vtkRenderer> renderer;
  SeeFrom(renderer, {10.0, -20.0, 2000.0});
  renderer->GetActiveCamera()->SetFocalPoint(10.0, -20.0, 4000.0);
  EXPECT_FALSE(FindSeen(renderer, seenSize, seenBox)) << "it is behind the camera";
  renderer->GetActiveCamera()->SetFocalPoint(3000.0, -20.0, 2000.0);
  EXPECT_FALSE(FindSeen(renderer, seenSize, seenBox)) << "it is below the picture";
}

// From all sides, also from within: what the picture shows of the box lies in the part.
TEST(SeenPart, HoldsAllThatIsShown)
{
  std::mt19937 random(3);
  const auto between = [&random](double least, double most)
  { return std::uniform_real_distribution<double>(least, most)(random); };
  int shown = 0;
  int missed = 0;
  for (int view = 0; view < 60; ++view)
  {
    vtkNew<vtkRenderer> renderer;
    SeeFrom(renderer, {between(-900.0, 900.0), between(-900.0, 900.0), between(10.0, 600.0)});
    vtkCamera* camera = renderer->GetActiveCamera();
    camera->SetViewUp(0.0, 0.0, 1.0);
    camera->SetViewAngle(between(3.0, 40.0));
    const auto seen = FindSeen(renderer, seenSize, seenBox);
    for (int i = 0; i < 500; ++i)
    {
      const std::array<double, 3> point = {between(seenBox[0], seenBox[1]),
        between(seenBox[2], seenBox[3]), between(seenBox[4], seenBox[5])};
      if (IsShown(camera, point))
      {
        ++shown;
        const bool held = seen && point[0] >= seen->faces[0] && point[0] <= seen->faces[1] &&
                          point[1] >= seen->faces[2] && point[1] <= seen->faces[3];
        missed += held ? 0 : 1;
      }
    }
  }
  EXPECT_GT(shown, 1000);
  EXPECT_EQ(missed, 0) << "of " << shown;
}

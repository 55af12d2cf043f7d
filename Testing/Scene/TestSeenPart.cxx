// SPDX-License-Identifier: BSD-3-Clause
// Which part of a box a picture shows, and how large its pixels are there.
#include "Scene/Frame/SeenPart.h"

#include "Tolerance.h"

#include <vtkCamera.h>
#include <vtkMath.h>
#include <vtkMatrix4x4.h>
#include <vtkNew.h>
#include <vtkRenderer.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

using namespace nexrad::scene;

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

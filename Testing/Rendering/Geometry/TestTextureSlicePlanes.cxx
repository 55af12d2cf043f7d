// SPDX-License-Identifier: BSD-3-Clause
// Where the slices lie, and how the rays go through them, against the inverse of the projection.
#include "Tolerance.h"
#include "vtkTextureSliceFrame.h"

#include "vtkMath.h"
#include "vtkMatrix4x4.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace
{

using Vector = std::array<double, 3>;
using Matrix = std::array<double, 16>;

double Depth(const vtkTextureSliceView& view, const Vector& p)
{
  const Matrix& m = view.BoxToCamera;
  return -(m[8] * p[0] + m[9] * p[1] + m[10] * p[2] + m[11]);
}

/// A unit box turned about two axes (radians), its middle at that depth.
vtkTextureSliceView TurnedView(double depth, double a = 0.5, double b = 0.9)
{
  // Rows: the camera's axes in box coordinates.
  const double rows[3][3] = {{std::cos(a), -std::sin(a), 0.0},
    {std::sin(a) * std::cos(b), std::cos(a) * std::cos(b), -std::sin(b)},
    {std::sin(a) * std::sin(b), std::cos(a) * std::sin(b), std::cos(b)}};
  vtkTextureSliceView view;
  for (std::size_t row = 0; row < 3; ++row)
  {
    double middle = 0.0;
    for (std::size_t column = 0; column < 3; ++column)
    {
      view.BoxToCamera[4 * row + column] = rows[row][column];
      middle += 0.5 * rows[row][column];
    }
    view.BoxToCamera[4 * row + 3] = -middle;
  }
  view.BoxToCamera[11] -= depth;
  return view;
}

/// A picture of 200 x 120 pixels, depths from 1 to 20.
void Project(vtkTextureSliceView& view, bool parallel)
{
  constexpr double nearDepth = 1.0;
  constexpr double farDepth = 20.0;
  constexpr double width = farDepth - nearDepth;
  const Matrix toClip =
    parallel ? Matrix{0.6, 0, 0, 0.1, 0, 1.0, 0, -0.05, 0, 0, -2.0 / width,
                 -(farDepth + nearDepth) / width, 0, 0, 0, 1}
             : Matrix{1.8, 0, 0.1, 0, 0, 3.0, 0, 0, 0, 0, -(farDepth + nearDepth) / width,
                 -2.0 * farDepth * nearDepth / width, 0, 0, -1, 0};
  vtkMatrix4x4::Multiply4x4(toClip.data(), view.BoxToCamera.data(), view.BoxToClip.data());
  view.NearDepth = nearDepth;
  view.Viewport = {200, 120};
}

Vector Transform(const Matrix& matrix, double x, double y, double z)
{
  const double in[4] = {x, y, z, 1.0};
  double out[4];
  vtkMatrix4x4::MultiplyPoint(matrix.data(), in, out);
  return {out[0] / out[3], out[1] / out[3], out[2] / out[3]};
}

/// Where the ray of a pixel is at that depth, by two points of it from the inverted projection.
Vector Unproject(const vtkTextureSliceView& view, double x, double y, double depth)
{
  Matrix clipToBox;
  vtkMatrix4x4::Invert(view.BoxToClip.data(), clipToBox.data());
  const double right = 2.0 * x / view.Viewport[0] - 1.0;
  const double up = 2.0 * y / view.Viewport[1] - 1.0;
  const Vector a = Transform(clipToBox, right, up, -1.0);
  const Vector b = Transform(clipToBox, right, up, 1.0);
  const double share = (depth - Depth(view, a)) / (Depth(view, b) - Depth(view, a));
  return {a[0] + share * (b[0] - a[0]), a[1] + share * (b[1] - a[1]), a[2] + share * (b[2] - a[2])};
}

double At(const vtkTextureSlicePixelMap& map, double x, double y, std::size_t axis)
{
  return map[0][axis] * x + map[1][axis] * y + map[2][axis];
}

vtkTextureSlicePlanes Place(const vtkTextureSliceView& view)
{
  vtkTextureSlicePlanes planes;
  planes.Place(view);
  return planes;
}

/// A box of 121 points or so many cells along each axis, seen along z; turned by that angle, in
/// degrees.
vtkTextureSliceView ViewOfVoxels(double degrees, bool cells = false)
{
  vtkTextureSliceView view = TurnedView(5.0, 0.0, vtkMath::RadiansFromDegrees(degrees));
  view.EdgeLength = {120, 120, 120};
  view.Faces = {120, 120, 120};
  const double first = cells ? 0.0 : 0.5 / 120;
  view.FirstFace = {first, first, first};
  return view;
}

/// The least distance of a slice to a face between voxels, in voxels, on the ray through the
/// middle.
double FindDistanceToFaces(const vtkTextureSliceView& view, const vtkTextureSlicePlanes& planes)
{
  const double middle = Depth(view, {0.5, 0.5, 0.5});
  double least = 1.0;
  for (int i = 0; i < planes.NumberOfSlices; ++i)
  {
    const double depth = planes.NearestDepth + i * planes.DepthStep;
    const double z = 0.5 - (depth - middle) / view.BoxToCamera[10];
    const double voxels = (z - view.FirstFace[2]) * view.Faces[2];
    least = std::min(least, std::abs(voxels - std::round(voxels)));
  }
  return least;
}

} // namespace

TEST(TextureSlicePlanes, LieInTheMiddleOfEqualIntervals)
{
  vtkTextureSliceView view = TurnedView(3.0);
  view.NumberOfSlices = 7;
  view.Part = {0.25, 0.75, 0.0, 1.0, 0.5, 1.0};
  double nearest = 1e9;
  double farthest = 0.0;
  for (int corner = 0; corner < 8; ++corner)
  {
    const double depth = Depth(view,
      {view.Part[corner & 1], view.Part[2 + (corner >> 1 & 1)], view.Part[4 + (corner >> 2 & 1)]});
    nearest = std::min(nearest, depth);
    farthest = std::max(farthest, depth);
  }
  const vtkTextureSlicePlanes planes = Place(view);
  EXPECT_EQ(planes.NumberOfSlices, 7);
  EXPECT_NEAR(planes.DepthStep, (farthest - nearest) / 7.0, 1e-12);
  EXPECT_NEAR(planes.NearestDepth, nearest + 0.5 * planes.DepthStep, 1e-12);
}

TEST(TextureSlicePlanes, NearPlaneCutsTheBox)
{
  vtkTextureSliceView view;
  view.BoxToCamera = {1, 0, 0, -0.5, 0, 1, 0, -0.5, 0, 0, 1, -0.5, 0, 0, 0, 1};
  view.NearDepth = 0.1;
  view.NumberOfSlices = 4;
  EXPECT_NEAR(Place(view).DepthStep, 0.1, 1e-12);
  EXPECT_NEAR(Place(view).NearestDepth, 0.15, 1e-12);

  view.NearDepth = 0.6; // the box ends at 0.5
  EXPECT_EQ(Place(view).NumberOfSlices, 0);
}

TEST(TextureSlicePlanes, StepIsADataLength)
{
  // A box 4 deep in data units that the actor's matrix squeezes to a depth of 1.
  vtkTextureSliceView view;
  view.BoxToCamera = {1, 0, 0, -0.5, 0, 1, 0, -0.5, 0, 0, 1, -3, 0, 0, 0, 1};
  view.EdgeLength = {1.0, 1.0, 4.0};
  view.NumberOfSlices = 0;
  view.SampleDistance = 0.5;
  EXPECT_EQ(Place(view).NumberOfSlices, 8);
  EXPECT_NEAR(Place(view).DataStep, 0.5, 1e-12);
  view.SampleDistance = 0.49;
  EXPECT_EQ(Place(view).NumberOfSlices, 9);
}

TEST(TextureSlicePlanes, TinySampleDistanceIsBounded)
{
  vtkTextureSliceView view = TurnedView(5.0);
  view.NumberOfSlices = 0;
  view.SampleDistance = 1e-12;
  EXPECT_EQ(Place(view).NumberOfSlices, vtkTextureSlicePlanes::MaximumNumberOfSlices);
}

TEST(TextureSlicePlanes, OnePlaneHasOneSlice)
{
  vtkTextureSliceView view = TurnedView(5.0);
  view.Plane = {0.0, 0.0, 1.0, -0.5};
  EXPECT_EQ(Place(view).NumberOfSlices, 1);
}

TEST(TextureSlicePlanes, RaysOfPixelsAreThoseOfTheProjection)
{
  for (const bool parallel : {false, true})
  {
    SCOPED_TRACE(parallel ? "parallel" : "perspective");
    vtkTextureSliceView view = TurnedView(3.0);
    Project(view, parallel);
    view.NumberOfSlices = 9;
    const vtkTextureSlicePlanes planes = Place(view);
    for (const auto& [x, y] : {std::pair(0.5, 0.5), {199.5, 0.5}, {31.5, 119.5}, {100.0, 60.0}})
    {
      for (int slice = 0; slice < 9; ++slice)
      {
        const Vector expected =
          Unproject(view, x, y, planes.NearestDepth + slice * planes.DepthStep);
        for (std::size_t axis = 0; axis < 3; ++axis)
        {
          EXPECT_NEAR(At(planes.Places, x, y, axis) + slice * At(planes.Steps, x, y, axis),
            expected[axis], 1e-9)
            << "pixel " << x << ", " << y << ", slice " << slice << ", axis " << axis;
        }
      }
    }
  }
}

TEST(TextureSlicePlanes, DepthsOfTheWindowAreThoseOfTheProjection)
{
  for (const bool parallel : {false, true})
  {
    vtkTextureSliceView view = TurnedView(3.0);
    Project(view, parallel);
    view.NumberOfSlices = 9;
    const vtkTextureSlicePlanes planes = Place(view);
    const auto [a, b, c, d] = planes.DepthToSlice;
    for (const double slice : {-0.5, 0.0, 1.3, 4.0, 8.5})
    {
      const Vector place =
        Unproject(view, 140.5, 20.5, planes.NearestDepth + slice * planes.DepthStep);
      const double depth = 0.5 + 0.5 * Transform(view.BoxToClip, place[0], place[1], place[2])[2];
      const double lack = 2.0 * (1.0 - depth);
      EXPECT_WITHIN(double{(a - lack * b) / (c + lack * d)}, slice, 5e-6,
        "place on a ray of a depth of the window, in slices")
        << (parallel ? "parallel" : "perspective");
    }
  }
}

// Slices on faces between voxels took one of two voxels by chance.
TEST(TextureSlicePlanes, NoneLieOnFacesBetweenVoxels)
{
  for (const bool cells : {false, true})
  {
    // Of cells every second face has a slice in the second case.
    const int onFaces = cells ? 60 : 120;
    for (const double degrees : {0.0, 0.001, -0.001})
    {
      SCOPED_TRACE(testing::Message() << (cells ? "cells" : "points") << ", " << degrees);
      vtkTextureSliceView view = ViewOfVoxels(degrees, cells);
      view.NumberOfSlices = onFaces;
      EXPECT_EQ(Place(view).NumberOfSlices, onFaces);
      EXPECT_AT_LEAST(FindDistanceToFaces(view, Place(view)), 0.24,
        "distance of a slice to a face, in voxels (0.25, less what the turned box is longer)");
    }
  }
}

TEST(TextureSlicePlanes, ATurnedCameraHasTheSameSlices)
{
  for (const int slices : {0, 119, 120, 121, 240})
  {
    vtkTextureSliceView straight = ViewOfVoxels(0.0);
    vtkTextureSliceView turned = ViewOfVoxels(0.001);
    straight.NumberOfSlices = slices;
    turned.NumberOfSlices = slices;
    EXPECT_EQ(Place(turned).NumberOfSlices, Place(straight).NumberOfSlices);
    EXPECT_EQ(Place(turned).NumberOfSlices, slices == 0 ? 120 : slices);
    EXPECT_AT_MOST(std::abs(Place(turned).NearestDepth - Place(straight).NearestDepth) * 120.0,
      0.002,
      "what a turn by 0.001 degrees moves the nearest slice by, in voxels (measured: 0.001)");
  }
}

TEST(TextureSlicePlanes, StayInTheMiddleWhereNoFacesAre)
{
  // Slices between faces, few by chance on them, samples that are interpolated, a view askew.
  vtkTextureSliceView interpolated = ViewOfVoxels(0.0);
  interpolated.Faces = {0, 0, 0};
  interpolated.NumberOfSlices = 120;
  vtkTextureSliceView askew = ViewOfVoxels(1.0);
  askew.NumberOfSlices = 120;
  vtkTextureSliceView between = ViewOfVoxels(0.0);
  between.NumberOfSlices = 240;
  vtkTextureSliceView byChance = ViewOfVoxels(0.0);
  byChance.NumberOfSlices = 121;
  for (const vtkTextureSliceView& view : {interpolated, askew, between, byChance})
  {
    const vtkTextureSlicePlanes planes = Place(view);
    const double farthest = planes.NearestDepth + (planes.NumberOfSlices - 1) * planes.DepthStep;
    EXPECT_NEAR(0.5 * (planes.NearestDepth + farthest), Depth(view, {0.5, 0.5, 0.5}), 1e-9);
  }
}

// SPDX-License-Identifier: BSD-3-Clause
#include "vtkTextureSliceGeometry.h"

#include <gtest/gtest.h>

#include <cmath>

namespace
{

constexpr std::size_t Stride = vtkTextureSliceGeometry::FloatsPerVertex;

std::array<double, 3> Point(const vtkTextureSliceGeometry& geometry, std::size_t vertex)
{
  const float* v = geometry.GetVertices().data() + vertex * Stride;
  return {v[0], v[1], v[2]};
}

double StepLength(const vtkTextureSliceGeometry& geometry, std::size_t vertex)
{
  const float* v = geometry.GetVertices().data() + vertex * Stride;
  return std::hypot(double(v[3]), double(v[4]), double(v[5]));
}

double Depth(const vtkTextureSliceView& view, const std::array<double, 3>& p)
{
  const auto& m = view.BoxToCamera;
  return -(m[8] * p[0] + m[9] * p[1] + m[10] * p[2] + m[11]);
}

/// Area in box coordinates of all triangles.
double TotalArea(const vtkTextureSliceGeometry& geometry)
{
  double area = 0.0;
  for (std::size_t t = 0; t + 2 < std::size_t(geometry.GetNumberOfVertices()); t += 3)
  {
    const auto a = Point(geometry, t);
    const auto b = Point(geometry, t + 1);
    const auto c = Point(geometry, t + 2);
    const double u[3] = {b[0] - a[0], b[1] - a[1], b[2] - a[2]};
    const double v[3] = {c[0] - a[0], c[1] - a[1], c[2] - a[2]};
    area += 0.5 * std::hypot(u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2],
                    u[0] * v[1] - u[1] * v[0]);
  }
  return area;
}

/// A unit box turned about two axes, its middle at that depth.
vtkTextureSliceView TurnedView(double depth)
{
  const double a = 0.5;
  const double b = 0.9;
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

} // namespace

TEST(TextureSliceGeometry, SlicesFillTheBox)
{
  // In a unit box, area times distance of all slices is the volume, 1.
  vtkTextureSliceView view = TurnedView(5.0);
  view.Parallel = true;
  view.NumberOfSlices = 1000;
  vtkTextureSliceGeometry geometry;
  geometry.Build(view);
  EXPECT_EQ(geometry.GetNumberOfSlices(), 1000);
  EXPECT_NEAR(TotalArea(geometry) * geometry.GetDepthStep(), 1.0, 1e-7);
}

TEST(TextureSliceGeometry, SlabsShareAPlane)
{
  vtkTextureSliceView view = TurnedView(5.0);
  view.Parallel = true;
  view.Slabs = 4;
  view.NumberOfSlices = 10;
  vtkTextureSliceGeometry geometry;
  geometry.Build(view);
  EXPECT_EQ(geometry.GetNumberOfPlanes(), 3);
  EXPECT_EQ(geometry.GetNumberOfSlices(), 12);
  view.NumberOfSlices = 4000;
  geometry.Build(view);
  EXPECT_EQ(geometry.GetNumberOfPlanes(), 1000);
  EXPECT_NEAR(TotalArea(geometry) * geometry.GetDepthStep(), 1.0, 1e-7);
}

// A layer between two planes of four slabs was not drawn.
TEST(TextureSliceGeometry, EachRayMeetsAThinLayer)
{
  vtkTextureSliceView view = TurnedView(5.0);
  view.Parallel = true;
  view.Slabs = 4;
  view.NumberOfSlices = 256;
  vtkTextureSliceGeometry geometry;
  geometry.Build(view);
  ASSERT_EQ(geometry.GetNumberOfPlanes(), 64);
  // By the part, and by clipping planes.
  for (const bool clips : {false, true})
  {
    view.Part = {0.0, 1.0, 0.0, 1.0, clips ? 0.0 : 0.5, clips ? 1.0 : 0.51};
    view.ClippingPlanes = {{0.0, 0.0, 1.0, -0.5}, {0.0, 0.0, -2.0, 1.02}};
    if (!clips)
    {
      view.ClippingPlanes.clear();
    }
    geometry.Build(view);
    // The depth of a ray within the layer, by the direction of depth in the box.
    const double along = std::abs(view.BoxToCamera[10]);
    EXPECT_LE(geometry.GetDepthStep(), 0.01 / along);
    EXPECT_LE(geometry.GetNumberOfPlanes(), 256);
  }
  view.NumberOfSlices = 4;
  geometry.Build(view);
  EXPECT_EQ(geometry.GetNumberOfPlanes(), 4) << "one for each slice at most";
}

TEST(TextureSliceGeometry, ClippingPlaneAndPartLeaveTheirShare)
{
  vtkTextureSliceView view = TurnedView(5.0);
  view.Parallel = true;
  view.NumberOfSlices = 1000;
  view.Part = {0.25, 0.75, 0.0, 1.0, 0.5, 1.0};
  vtkTextureSliceGeometry geometry;
  geometry.Build(view);
  EXPECT_NEAR(TotalArea(geometry) * geometry.GetDepthStep(), 0.25, 1e-7);

  // Keeps x + y >= 1: half of what is left.
  view.ClippingPlanes = {{1.0, 1.0, 0.0, -1.0}};
  geometry.Build(view);
  EXPECT_NEAR(TotalArea(geometry) * geometry.GetDepthStep(), 0.125, 1e-7);
}

TEST(TextureSliceGeometry, SlicesComeNearestFirstAtEqualDepths)
{
  vtkTextureSliceView view = TurnedView(3.0);
  view.NumberOfSlices = 7;
  vtkTextureSliceGeometry geometry;
  geometry.Build(view);
  double last = 0.0;
  int slices = 0;
  for (std::size_t t = 0; t + 2 < std::size_t(geometry.GetNumberOfVertices()); t += 3)
  {
    const double depth = Depth(view, Point(geometry, t));
    EXPECT_NEAR(Depth(view, Point(geometry, t + 1)), depth, 1e-6);
    EXPECT_NEAR(Depth(view, Point(geometry, t + 2)), depth, 1e-6);
    if (depth > last + 1e-5)
    {
      EXPECT_TRUE(slices == 0 || std::abs(depth - last - geometry.GetDepthStep()) < 1e-5);
      ++slices;
      last = depth;
    }
    EXPECT_NEAR(depth, last, 1e-5);
  }
  EXPECT_EQ(slices, 7);
}

TEST(TextureSliceGeometry, StepGrowsAwayFromTheAxisOfAPerspective)
{
  // The box face on, 2 away from the eye: a ray to a corner of a slice at depth d, (0.5, 0.5) off
  // the axis, is sqrt(d^2 + 0.5) / d times as long as the axis (Formulas R1).
  vtkTextureSliceView view;
  view.BoxToCamera = {1, 0, 0, -0.5, 0, 1, 0, -0.5, 0, 0, 1, -3, 0, 0, 0, 1};
  view.NumberOfSlices = 10;
  vtkTextureSliceGeometry geometry;
  geometry.Build(view);
  ASSERT_EQ(geometry.GetNumberOfVertices(), 10 * 2 * 3);
  EXPECT_NEAR(geometry.GetDepthStep(), 0.1, 1e-12);
  for (std::size_t v = 0; v < std::size_t(geometry.GetNumberOfVertices()); ++v)
  {
    const double depth = Depth(view, Point(geometry, v));
    EXPECT_NEAR(StepLength(geometry, v), 0.1 * std::sqrt(depth * depth + 0.5) / depth, 1e-6);
  }
}

TEST(TextureSliceGeometry, StepIsADataLength)
{
  // A box 4 deep in data units that the actor's matrix squeezes to a depth of 1.
  vtkTextureSliceView view;
  view.BoxToCamera = {1, 0, 0, -0.5, 0, 1, 0, -0.5, 0, 0, 1, -3, 0, 0, 0, 1};
  view.Parallel = true;
  view.EdgeLength = {1.0, 1.0, 4.0};
  view.NumberOfSlices = 0;
  view.SampleDistance = 0.5;
  vtkTextureSliceGeometry geometry;
  geometry.Build(view);
  EXPECT_EQ(geometry.GetNumberOfSlices(), 8);
  EXPECT_NEAR(StepLength(geometry, 0), 0.5, 1e-6);
}

TEST(TextureSliceGeometry, NearPlaneCutsTheSlices)
{
  vtkTextureSliceView view;
  view.BoxToCamera = {1, 0, 0, -0.5, 0, 1, 0, -0.5, 0, 0, 1, -0.5, 0, 0, 0, 1};
  view.NearDepth = 0.1;
  view.NumberOfSlices = 4;
  vtkTextureSliceGeometry geometry;
  geometry.Build(view);
  EXPECT_NEAR(geometry.GetDepthStep(), 0.1, 1e-12);

  view.NearDepth = 0.6; // the box ends at 0.5
  geometry.Build(view);
  EXPECT_EQ(geometry.GetNumberOfSlices(), 0);
  EXPECT_EQ(geometry.GetNumberOfVertices(), 0);
}

TEST(TextureSliceGeometry, TinySampleDistanceIsBounded)
{
  vtkTextureSliceView view = TurnedView(5.0);
  view.NumberOfSlices = 0;
  view.SampleDistance = 1e-12;
  vtkTextureSliceGeometry geometry;
  geometry.Build(view);
  EXPECT_EQ(geometry.GetNumberOfSlices(), vtkTextureSliceGeometry::MaximumNumberOfSlices);
}

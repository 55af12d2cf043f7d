// SPDX-License-Identifier: BSD-3-Clause
#include "vtkTextureSlicePlanes.h"

#include "vtkMath.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace
{

using Vector = std::array<double, 3>;
using Plane = std::array<double, 4>;

double Evaluate(const Plane& plane, const Vector& p)
{
  return plane[0] * p[0] + plane[1] * p[1] + plane[2] * p[2] + plane[3];
}

Plane RowOf(const std::array<double, 16>& matrix, std::size_t row)
{
  return {matrix[4 * row], matrix[4 * row + 1], matrix[4 * row + 2], matrix[4 * row + 3]};
}

Vector Corner(const vtkTextureSliceView& view, std::size_t number)
{
  return {
    view.Part[number & 1], view.Part[2 + ((number >> 1) & 1)], view.Part[4 + ((number >> 2) & 1)]};
}

/// The depth of a place as a function of its box coordinates.
Plane MakeDepth(const vtkTextureSliceView& view)
{
  const Plane z = RowOf(view.BoxToCamera, 2);
  return {-z[0], -z[1], -z[2], -z[3]};
}

/// Nearest and farthest depth of the part of the box in front of the near plane.
std::pair<double, double> DepthRange(const vtkTextureSliceView& view, const Plane& depth)
{
  double nearest = std::numeric_limits<double>::max();
  double farthest = std::numeric_limits<double>::lowest();
  for (std::size_t corner = 0; corner < 8; ++corner)
  {
    const double value = Evaluate(depth, Corner(view, corner));
    nearest = std::min(nearest, value);
    farthest = std::max(farthest, value);
  }
  return {std::max(nearest, view.NearDepth), farthest};
}

/// The axis of the view in box coordinates, for one unit of depth.
Vector ViewDirection(const vtkTextureSliceView& view)
{
  const auto& m = view.BoxToCamera;
  const double rows[3][3] = {{m[0], m[1], m[2]}, {m[4], m[5], m[6]}, {m[8], m[9], m[10]}};
  const double back[3] = {0.0, 0.0, -1.0};
  Vector direction{};
  vtkMath::LinearSolve3x3(rows, back, direction.data());
  return direction;
}

/// How far the slices must go towards the eye so that none of them lies on faces between voxels:
/// there the scalar jumps, and rounding would take now the one voxel and now the other.
double FindShift(
  const vtkTextureSliceView& view, const Plane& depth, double nearest, double depthStep, int slices)
{
  constexpr double close = 0.05; // of a voxel
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    // The depth of a voxel, and how far the depths of a plane of voxels differ.
    const double voxel = view.Faces[axis] > 0.0 ? std::abs(depth[axis]) / view.Faces[axis] : 0.0;
    const double others = std::abs(depth[(axis + 1) % 3]) + std::abs(depth[(axis + 2) % 3]);
    if (voxel <= 0.0 || others > close * voxel)
    {
      continue;
    }
    const double middles = 0.5 * (depth[(axis + 1) % 3] + depth[(axis + 2) % 3]) + depth[3];
    int onFaces = 0;
    for (int i = 0; i < slices; ++i)
    {
      const double place = (nearest + (i + 0.5) * depthStep - middles) / depth[axis];
      const double voxels = (place - view.FirstFace[axis]) * view.Faces[axis];
      onFaces += std::abs(voxels - std::round(voxels)) < close ? 1 : 0;
    }
    // By chance, one slice in ten is that close to a face.
    return onFaces * 5 > slices ? 0.25 * std::min(voxel, depthStep) : 0.0;
  }
  return 0.0;
}

int CountSlices(const vtkTextureSliceView& view, double nearest, double farthest)
{
  const double thickness = farthest - nearest;
  double count = view.NumberOfSlices;
  if (view.NumberOfSlices <= 0)
  {
    const Vector direction = ViewDirection(view);
    const double perDepth = std::hypot(direction[0] * view.EdgeLength[0],
      direction[1] * view.EdgeLength[1], direction[2] * view.EdgeLength[2]);
    constexpr double rounding = 0.01; // a camera that is turned a little sees as many slices
    count = std::ceil(thickness * perDepth / view.SampleDistance - rounding);
  }
  return static_cast<int>(
    std::clamp(count, 1.0, double{vtkTextureSlicePlanes::MaximumNumberOfSlices}));
}

/// Where the rays of the pixels meet the plane of that depth. On it, the last clip coordinate is
/// the same everywhere.
vtkTextureSlicePixelMap MapPixels(const vtkTextureSliceView& view, double depthOfPlane)
{
  const Plane right = RowOf(view.BoxToClip, 0);
  const Plane up = RowOf(view.BoxToClip, 1);
  const Plane depth = MakeDepth(view);
  const double rows[3][3] = {
    {right[0], right[1], right[2]}, {up[0], up[1], up[2]}, {depth[0], depth[1], depth[2]}};
  const auto solve = [&rows](double x, double y, double z)
  {
    const double known[3] = {x, y, z};
    Vector place{};
    vtkMath::LinearSolve3x3(rows, known, place.data());
    return place;
  };
  const Vector somewhere = solve(0.0, 0.0, depthOfPlane - depth[3]);
  const double w = Evaluate(RowOf(view.BoxToClip, 3), somewhere);
  vtkTextureSlicePixelMap map;
  map.Right = solve(2.0 * w / view.Viewport[0], 0.0, 0.0);
  map.Up = solve(0.0, 2.0 * w / view.Viewport[1], 0.0);
  map.Origin = solve(-w - right[3], -w - up[3], depthOfPlane - depth[3]);
  return map;
}

Vector Minus(const Vector& a, const Vector& b)
{
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}

std::array<float, 4> MapDepths(
  const vtkTextureSliceView& view, const Vector& onNearest, const Vector& toNext)
{
  const Plane zRow = RowOf(view.BoxToClip, 2);
  const Plane wRow = RowOf(view.BoxToClip, 3);
  const double z = Evaluate(zRow, onNearest);
  const double w = Evaluate(wRow, onNearest);
  const double zStep = Evaluate({zRow[0], zRow[1], zRow[2], 0.0}, toNext);
  const double wStep = Evaluate({wRow[0], wRow[1], wRow[2], 0.0}, toNext);
  return {static_cast<float>(w - z), static_cast<float>(w), static_cast<float>(zStep - wStep),
    static_cast<float>(wStep)};
}

} // namespace

void vtkTextureSlicePlanes::Place(const vtkTextureSliceView& view)
{
  *this = vtkTextureSlicePlanes();
  const Plane depth = MakeDepth(view);
  const auto [nearest, farthest] = DepthRange(view, depth);
  if (!(nearest < farthest))
  {
    return;
  }
  this->NumberOfSlices = view.Plane ? 1 : CountSlices(view, nearest, farthest);
  this->DepthStep = (farthest - nearest) / this->NumberOfSlices;
  this->NearestDepth = nearest + 0.5 * this->DepthStep -
                       FindShift(view, depth, nearest, this->DepthStep, this->NumberOfSlices);
  const Vector direction = ViewDirection(view);
  this->DataStep =
    this->DepthStep * std::hypot(direction[0] * view.EdgeLength[0],
                        direction[1] * view.EdgeLength[1], direction[2] * view.EdgeLength[2]);
  this->Places = MapPixels(view, this->NearestDepth);
  const vtkTextureSlicePixelMap next = MapPixels(view, this->NearestDepth + this->DepthStep);
  this->Steps = {Minus(next.Right, this->Places.Right), Minus(next.Up, this->Places.Up),
    Minus(next.Origin, this->Places.Origin)};
  this->DepthToSlice = MapDepths(view, this->Places.Origin, this->Steps.Origin);
}

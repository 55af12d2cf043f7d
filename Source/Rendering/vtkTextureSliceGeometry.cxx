// SPDX-License-Identifier: BSD-3-Clause
#include "vtkTextureSliceGeometry.h"

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

Vector Cross(const Vector& a, const Vector& b)
{
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

double Length(const Vector& v)
{
  return std::hypot(v[0], v[1], v[2]);
}

Vector Scaled(const Vector& v, double factor)
{
  return {v[0] * factor, v[1] * factor, v[2] * factor};
}

/// The camera as the box sees it.
struct Eye
{
  Plane Depth;      ///< depth of a point, world units
  Vector Position;  ///< of the eye, meaningless in a parallel view
  Vector Direction; ///< of the view's axis, for one unit of depth
};

/// Solves m * x = rhs for the upper left 3x3 of a row-major 4x4 matrix by Cramer's rule.
Vector Solve(const std::array<double, 16>& m, const Vector& rhs)
{
  const Vector x{m[0], m[4], m[8]};
  const Vector y{m[1], m[5], m[9]};
  const Vector z{m[2], m[6], m[10]};
  const auto dot = [](const Vector& a, const Vector& b)
  { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; };
  const double determinant = dot(x, Cross(y, z));
  return {dot(rhs, Cross(y, z)) / determinant, dot(x, Cross(rhs, z)) / determinant,
    dot(x, Cross(y, rhs)) / determinant};
}

Eye MakeEye(const vtkTextureSliceView& view)
{
  const auto& m = view.BoxToCamera;
  return {
    {-m[8], -m[9], -m[10], -m[11]}, Solve(m, {-m[3], -m[7], -m[11]}), Solve(m, {0.0, 0.0, -1.0})};
}

/// Half-spaces whose intersection is what can be seen of the volume.
std::vector<Plane> MakeLimits(const vtkTextureSliceView& view)
{
  const auto& part = view.Part;
  std::vector<Plane> limits{{1, 0, 0, -part[0]}, {-1, 0, 0, part[1]}, {0, 1, 0, -part[2]},
    {0, -1, 0, part[3]}, {0, 0, 1, -part[4]}, {0, 0, -1, part[5]}};
  limits.insert(limits.end(), view.ClippingPlanes.begin(), view.ClippingPlanes.end());
  return limits;
}

/// Sutherland and Hodgman: the part of a convex polygon on the positive side of a plane.
void ClipPolygon(const std::vector<Vector>& polygon, const Plane& plane, std::vector<Vector>& kept)
{
  kept.clear();
  for (std::size_t i = 0; i < polygon.size(); ++i)
  {
    const Vector& a = polygon[i];
    const Vector& b = polygon[(i + 1) % polygon.size()];
    const double valueA = Evaluate(plane, a);
    const double valueB = Evaluate(plane, b);
    if (valueA >= 0.0)
    {
      kept.push_back(a);
    }
    if ((valueA >= 0.0) != (valueB >= 0.0))
    {
      const double t = valueA / (valueA - valueB);
      kept.push_back(
        {a[0] + t * (b[0] - a[0]), a[1] + t * (b[1] - a[1]), a[2] + t * (b[2] - a[2])});
    }
  }
}

/// Makes the polygon of one depth after another, reusing its buffers.
class Slicer
{
public:
  Slicer(const Plane& depth, std::vector<Plane> limits)
    : Depth(depth)
    , Limits(std::move(limits))
  {
    const Vector gradient{depth[0], depth[1], depth[2]};
    this->GradientLength = Length(gradient);
    this->Normal = Scaled(gradient, 1.0 / this->GradientLength);
    // The axis least along the normal makes the best-conditioned pair of vectors in the plane.
    Vector axis{0.0, 0.0, 0.0};
    const auto smallest = std::min_element(this->Normal.begin(), this->Normal.end(),
      [](double a, double b) { return std::abs(a) < std::abs(b); });
    axis[static_cast<std::size_t>(smallest - this->Normal.begin())] = 1.0;
    const Vector right = Cross(this->Normal, axis);
    this->Right = Scaled(right, 1.0 / Length(right));
    this->Up = Cross(this->Normal, this->Right);
  }

  const std::vector<Vector>& Cut(double depth)
  {
    // A square about the middle of the box, larger than its diagonal, at that depth.
    const Vector middle{0.5, 0.5, 0.5};
    const double offset = (depth - Evaluate(this->Depth, middle)) / this->GradientLength;
    this->Polygon.clear();
    for (const auto& [r, u] : {std::pair(-1.0, -1.0), {1.0, -1.0}, {1.0, 1.0}, {-1.0, 1.0}})
    {
      Vector corner;
      for (std::size_t i = 0; i < 3; ++i)
      {
        corner[i] = middle[i] + offset * this->Normal[i] + r * this->Right[i] + u * this->Up[i];
      }
      this->Polygon.push_back(corner);
    }
    for (const Plane& limit : this->Limits)
    {
      ClipPolygon(this->Polygon, limit, this->Kept);
      std::swap(this->Polygon, this->Kept);
    }
    return this->Polygon;
  }

private:
  Plane Depth;
  std::vector<Plane> Limits;
  double GradientLength = 0.0;
  Vector Normal{};
  Vector Right{};
  Vector Up{};
  std::vector<Vector> Polygon;
  std::vector<Vector> Kept;
};

/// Nearest and farthest depth of the part of the box in front of the near plane.
std::pair<double, double> DepthRange(const vtkTextureSliceView& view, const Plane& depth)
{
  double nearest = std::numeric_limits<double>::max();
  double farthest = std::numeric_limits<double>::lowest();
  for (std::size_t corner = 0; corner < 8; ++corner)
  {
    const Vector p{view.Part[corner & 1], view.Part[2 + ((corner >> 1) & 1)],
      view.Part[4 + ((corner >> 2) & 1)]};
    const double value = Evaluate(depth, p);
    nearest = std::min(nearest, value);
    farthest = std::max(farthest, value);
  }
  return {std::max(nearest, view.NearDepth), farthest};
}

int CountSlices(const vtkTextureSliceView& view, double thickness, const Vector& direction)
{
  if (view.NumberOfSlices > 0)
  {
    return std::min(view.NumberOfSlices, vtkTextureSliceGeometry::MaximumNumberOfSlices);
  }
  const Vector dataDirection{direction[0] * view.EdgeLength[0], direction[1] * view.EdgeLength[1],
    direction[2] * view.EdgeLength[2]};
  const double count = std::ceil(thickness * Length(dataDirection) / view.SampleDistance);
  return static_cast<int>(
    std::clamp(count, 1.0, double{vtkTextureSliceGeometry::MaximumNumberOfSlices}));
}

} // namespace

void vtkTextureSliceGeometry::Build(const vtkTextureSliceView& view)
{
  this->Vertices.clear();
  this->NumberOfSlices = 0;
  this->DepthStep = 0.0;

  const Eye eye = MakeEye(view);
  const auto [nearest, farthest] = DepthRange(view, eye.Depth);
  if (!(nearest < farthest))
  {
    return;
  }
  this->NumberOfSlices = CountSlices(view, farthest - nearest, eye.Direction);
  this->DepthStep = (farthest - nearest) / this->NumberOfSlices;

  Slicer slicer(eye.Depth, MakeLimits(view));
  const auto append = [&](const Vector& p, double depth)
  {
    for (const double coordinate : p)
    {
      this->Vertices.push_back(static_cast<float>(coordinate));
    }
    for (std::size_t i = 0; i < 3; ++i)
    {
      // In a perspective view the ray leaves the eye: it crosses one unit of depth faster the
      // farther it points from the axis.
      const double perDepth = view.Parallel ? eye.Direction[i] : (p[i] - eye.Position[i]) / depth;
      this->Vertices.push_back(static_cast<float>(perDepth * this->DepthStep * view.EdgeLength[i]));
    }
  };
  for (int slice = 0; slice < this->NumberOfSlices; ++slice)
  {
    const double depth = farthest - (slice + 0.5) * this->DepthStep;
    const std::vector<Vector>& polygon = slicer.Cut(depth);
    for (std::size_t i = 2; i < polygon.size(); ++i)
    {
      append(polygon[0], depth);
      append(polygon[i - 1], depth);
      append(polygon[i], depth);
    }
  }
}

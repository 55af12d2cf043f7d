// SPDX-License-Identifier: BSD-3-Clause
#include "vtkTextureSliceGeometry.h"

#include "vtkSMPTools.h"
#include "vtkTextureSliceOpaquePixels.h"
#include "vtkTextureSliceTiles.h"

#include <algorithm>
#include <cmath>
#include <limits>

using vtkTextureSlice::ClipPolygon;
using vtkTextureSlice::Evaluate;
using vtkTextureSlice::Plane;
using vtkTextureSlice::Polygon;
using vtkTextureSlice::Vector;

/// The camera as the box sees it.
struct vtkTextureSliceEye
{
  Plane Depth;      ///< depth of a point, world units
  Vector Position;  ///< of the eye, meaningless in a parallel view
  Vector Direction; ///< of the view's axis, for one unit of depth
};

namespace
{

Vector Cross(const Vector& a, const Vector& b)
{
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

double Dot(const Vector& a, const Vector& b)
{
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

double Length(const Vector& v)
{
  return std::hypot(v[0], v[1], v[2]);
}

Vector Scaled(const Vector& v, double factor)
{
  return {v[0] * factor, v[1] * factor, v[2] * factor};
}

/// Solves m * x = rhs for the upper left 3x3 of a row-major 4x4 matrix by Cramer's rule.
Vector Solve(const std::array<double, 16>& m, const Vector& rhs)
{
  const Vector x{m[0], m[4], m[8]};
  const Vector y{m[1], m[5], m[9]};
  const Vector z{m[2], m[6], m[10]};
  const double determinant = Dot(x, Cross(y, z));
  return {Dot(rhs, Cross(y, z)) / determinant, Dot(x, Cross(rhs, z)) / determinant,
    Dot(x, Cross(y, rhs)) / determinant};
}

vtkTextureSliceEye MakeEye(const vtkTextureSliceView& view)
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

  const Polygon& Cut(double depth)
  {
    // A square about the middle of the box, larger than its diagonal.
    this->Current.clear();
    for (const auto& [r, u] : {std::pair(-1.0, -1.0), {1.0, -1.0}, {1.0, 1.0}, {-1.0, 1.0}})
    {
      this->Current.push_back(this->GetPoint(depth, r, u));
    }
    for (const Plane& limit : this->Limits)
    {
      ClipPolygon(this->Current, limit, this->Kept);
      std::swap(this->Current, this->Kept);
    }
    return this->Current;
  }

  /// A point of the plane of that depth; (0, 0) is nearest to the middle of the box.
  Vector GetPoint(double depth, double right, double up) const
  {
    Vector point{0.5, 0.5, 0.5};
    const double offset = (depth - Evaluate(this->Depth, point)) / this->GradientLength;
    for (std::size_t i = 0; i < 3; ++i)
    {
      point[i] += offset * this->Normal[i] + right * this->Right[i] + up * this->Up[i];
    }
    return point;
  }

private:
  Plane Depth;
  std::vector<Plane> Limits;
  double GradientLength = 0.0;
  Vector Normal{};
  Vector Right{};
  Vector Up{};
  Polygon Current;
  Polygon Kept;
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

/// Data length of one unit of depth along the axis of the view.
double DataLength(const vtkTextureSliceView& view, const Vector& direction)
{
  return Length({direction[0] * view.EdgeLength[0], direction[1] * view.EdgeLength[1],
    direction[2] * view.EdgeLength[2]});
}

int CountSlices(const vtkTextureSliceView& view, double thickness, const Vector& direction)
{
  if (view.NumberOfSlices > 0)
  {
    return std::min(view.NumberOfSlices, vtkTextureSliceGeometry::MaximumNumberOfSlices);
  }
  const double count = std::ceil(thickness * DataLength(view, direction) / view.SampleDistance);
  return static_cast<int>(
    std::clamp(count, 1.0, double{vtkTextureSliceGeometry::MaximumNumberOfSlices}));
}

/// Directions of the rays through the corners of the part, for one unit of depth; of a parallel
/// view that of all rays.
std::vector<Vector> RaysToCorners(const vtkTextureSliceView& view, const vtkTextureSliceEye& eye)
{
  std::vector<Vector> rays = {eye.Direction};
  for (std::size_t corner = 0; corner < 8 && !view.Parallel; ++corner)
  {
    const Vector p{view.Part[corner & 1], view.Part[2 + ((corner >> 1) & 1)],
      view.Part[4 + ((corner >> 2) & 1)]};
    const double depth = Evaluate(eye.Depth, p);
    if (depth > view.NearDepth && depth > 0.0)
    {
      rays.push_back({(p[0] - eye.Position[0]) / depth, (p[1] - eye.Position[1]) / depth,
        (p[2] - eye.Position[2]) / depth});
    }
  }
  return rays;
}

/// The least depth that a ray goes through between two parallel planes that limit what is drawn.
double LeastDepth(const vtkTextureSliceView& view, const vtkTextureSliceEye& eye)
{
  const std::vector<Plane> limits = MakeLimits(view);
  const std::vector<Vector> rays = RaysToCorners(view, eye);
  double least = std::numeric_limits<double>::max();
  for (const Plane& limit : limits)
  {
    const Vector normal{limit[0], limit[1], limit[2]};
    for (const Plane& other : limits)
    {
      const Vector otherNormal{other[0], other[1], other[2]};
      const double cosine = Dot(normal, otherNormal) / (Length(normal) * Length(otherNormal));
      constexpr double opposite = -1.0 + 1e-9;
      if (!(cosine < opposite))
      {
        continue;
      }
      const double thickness = limit[3] / Length(normal) + other[3] / Length(otherNormal);
      for (const Vector& ray : rays)
      {
        const double approach = std::abs(Dot(normal, ray)) / Length(normal);
        least = thickness > 0.0 && approach > 0.0 ? std::min(least, thickness / approach) : least;
      }
    }
  }
  return least;
}

/// Planes for so many slices. Where slices stand for slabs, a plane has several of them: a layer
/// that is thinner than the way between two planes has as many as it takes for each ray to meet
/// one, up to one for each slice.
int CountPlanes(
  const vtkTextureSliceView& view, const vtkTextureSliceEye& eye, int slices, double thickness)
{
  const int slabs = std::max(1, view.Slabs);
  const int planes = (slices + slabs - 1) / slabs;
  const int most = std::min(slices, vtkTextureSliceGeometry::MaximumNumberOfSlices / slabs);
  const double needed = thickness / LeastDepth(view, eye);
  return slabs == 1 || planes >= most
           ? planes
           : static_cast<int>(std::clamp(std::ceil(needed), 1.0 * planes, 1.0 * most));
}

/// Dense bricks, if enough slices of them make the picture opaque soon enough to be worth it.
vtkTextureSliceDensity MakeDensity(const vtkTextureSliceView& view, double dataStep, int slices)
{
  if (view.Dense == nullptr || view.DenseTransmittance >= 1.0)
  {
    return {};
  }
  const double steps = std::log(1.0 - vtkTextureSliceOpaquePixels::Opaque) /
                       (dataStep * std::log(std::max(1e-300, view.DenseTransmittance)));
  if (steps > 0.5 * slices)
  {
    return {};
  }
  // The first sample on a ray may stand for half a step.
  return {view.Dense, static_cast<int>(std::max(1.0, std::ceil(steps + 0.5)))};
}

/// z and w of clip coordinates for that depth, the same along every ray.
std::array<float, 2> MakeClipStep(
  const vtkTextureSliceView& view, const vtkTextureSliceEye& eye, double depth)
{
  const auto& m = view.BoxToClip;
  const Vector step = Scaled(eye.Direction, depth);
  return {static_cast<float>(Evaluate({m[8], m[9], m[10], 0.0}, step)),
    static_cast<float>(Evaluate({m[12], m[13], m[14], 0.0}, step))};
}

/// Where the rays through a plane of that depth go to.
vtkTextureSliceSegments MakeSegments(
  const vtkTextureSliceView& view, const vtkTextureSliceEye& eye, double depth, double depthStep)
{
  vtkTextureSliceSegments segments;
  segments.Growth = view.Parallel ? 0.0 : depthStep / depth;
  segments.Step =
    view.Parallel ? Scaled(eye.Direction, depthStep) : Scaled(eye.Position, -segments.Growth);
  segments.Part = view.Part;
  const double slab = view.ClippingPlanes.empty() ? 0.5 : 1.0;
  segments.Reach = view.Surfaces ? std::array<double, 2>{1.0, 0.0} : std::array{slab, slab};
  return segments;
}

/// From box coordinates to pixels of the viewport, and back in the plane of a slice.
class Screen
{
public:
  explicit Screen(const vtkTextureSliceView& view)
    : View(view)
  {
  }

  Vector ToPixels(const Vector& p) const
  {
    const auto& m = this->View.BoxToClip;
    const double w = Evaluate({m[12], m[13], m[14], m[15]}, p);
    return {0.5 * (1.0 + Evaluate({m[0], m[1], m[2], m[3]}, p) / w) * this->View.Viewport[0],
      0.5 * (1.0 + Evaluate({m[4], m[5], m[6], m[7]}, p) / w) * this->View.Viewport[1], 0.0};
  }

  /// Depth is the same all over a slice: pixels are an affine function of the place in it.
  void Place(const Slicer& slicer, double depth, const Polygon& outline,
    vtkTextureSliceOnScreen& slice) const
  {
    const Vector middle = slicer.GetPoint(depth, 0.0, 0.0);
    const Vector right = slicer.GetPoint(depth, 1.0, 0.0);
    const Vector up = slicer.GetPoint(depth, 0.0, 1.0);
    const Vector m = this->ToPixels(middle);
    const Vector r = this->ToPixels(right);
    const Vector u = this->ToPixels(up);
    const double determinant = (r[0] - m[0]) * (u[1] - m[1]) - (r[1] - m[1]) * (u[0] - m[0]);
    for (std::size_t i = 0; i < 3; ++i)
    {
      const double alongRight = (right[i] - middle[i]) / determinant;
      const double alongUp = (up[i] - middle[i]) / determinant;
      slice.Right[i] = alongRight * (u[1] - m[1]) - alongUp * (r[1] - m[1]);
      slice.Up[i] = alongUp * (r[0] - m[0]) - alongRight * (u[0] - m[0]);
      slice.Origin[i] = middle[i] - m[0] * slice.Right[i] - m[1] * slice.Up[i];
    }
    slice.Outline.clear();
    for (const Vector& corner : outline)
    {
      slice.Outline.push_back(this->ToPixels(corner));
    }
  }

  static Vector ToBox(const vtkTextureSliceOnScreen& slice, const Vector& pixel)
  {
    Vector p;
    for (std::size_t i = 0; i < 3; ++i)
    {
      p[i] = slice.Origin[i] + pixel[0] * slice.Right[i] + pixel[1] * slice.Up[i];
    }
    return p;
  }

private:
  const vtkTextureSliceView& View;
};

} // namespace

/// Writes polygons as triangles.
class vtkTextureSliceGeometry::TriangleWriter
{
public:
  TriangleWriter(const vtkTextureSliceView& view, const vtkTextureSliceEye& eye, double depthStep)
    : View(view)
    , FromEye(eye)
    , DepthStep(depthStep)
  {
  }

  /// Appends a polygon in box coordinates.
  void Add(const Polygon& polygon, double depth, std::vector<float>& vertices) const
  {
    for (std::size_t i = 2; i < polygon.size(); ++i)
    {
      this->Add(polygon[0], depth, vertices);
      this->Add(polygon[i - 1], depth, vertices);
      this->Add(polygon[i], depth, vertices);
    }
  }

private:
  void Add(const Vector& p, double depth, std::vector<float>& vertices) const
  {
    std::array<float, vtkTextureSliceGeometry::FloatsPerVertex> vertex;
    for (std::size_t i = 0; i < 3; ++i)
    {
      // In a perspective view the ray leaves the eye: it crosses one unit of depth faster the
      // farther it points from the axis.
      const double perDepth = this->View.Parallel ? this->FromEye.Direction[i]
                                                  : (p[i] - this->FromEye.Position[i]) / depth;
      vertex[i] = static_cast<float>(p[i]);
      vertex[i + 3] = static_cast<float>(perDepth * this->DepthStep * this->View.EdgeLength[i]);
    }
    vertices.insert(vertices.end(), vertex.begin(), vertex.end());
  }

  const vtkTextureSliceView& View;
  const vtkTextureSliceEye& FromEye;
  double DepthStep;
};

/// A slice before it is divided.
struct vtkTextureSliceGeometry::Placed
{
  double Depth = 0.0;
  Polygon Outline;   ///< box coordinates
  bool Whole = true; ///< not to be divided
  vtkTextureSliceOnScreen OnScreen;
};

std::vector<vtkTextureSliceGeometry::Placed> vtkTextureSliceGeometry::PlaceSlices(
  const vtkTextureSliceView& view, const vtkTextureSliceEye& eye, double nearest,
  bool divides) const
{
  Slicer slicer(eye.Depth, MakeLimits(view));
  const Screen screen(view);
  std::vector<Placed> slices(static_cast<std::size_t>(this->NumberOfPlanes));
  for (std::size_t i = 0; i < slices.size(); ++i)
  {
    Placed& slice = slices[i];
    slice.Depth = nearest + (static_cast<double>(i) + 0.5) * this->DepthStep;
    slice.Outline = slicer.Cut(slice.Depth);
    if (view.Occupancy != nullptr)
    {
      screen.Place(slicer, slice.Depth, slice.Outline, slice.OnScreen);
      if (view.Slabs > 0 || view.Surfaces)
      {
        slice.OnScreen.Segments = MakeSegments(view, eye, slice.Depth, this->DepthStep);
      }
      const vtkTextureSlicePixels picture{0, 0, view.Viewport[0], view.Viewport[1]};
      slice.Whole = !divides && vtkTextureSliceTiles::FindVisible(*view.Occupancy, slice.OnScreen,
                                  picture) == vtkTextureSliceOccupancy::Share::Everything;
    }
  }
  return slices;
}

void vtkTextureSliceGeometry::DivideSlices(const std::vector<Placed>& slices,
  vtkTextureSliceTiles& tiles, const TriangleWriter& writer, Row& row)
{
  row.Vertices.clear();
  row.Ends.clear();
  Polygon part;
  for (const Placed& slice : slices)
  {
    if (!slice.Whole)
    {
      for (const Polygon& tile : tiles.Cover(slice.OnScreen))
      {
        part.clear();
        for (const Vector& corner : tile)
        {
          part.push_back(Screen::ToBox(slice.OnScreen, corner));
        }
        writer.Add(part, slice.Depth, row.Vertices);
      }
    }
    row.Ends.push_back(row.Vertices.size());
  }
}

void vtkTextureSliceGeometry::Join(const std::vector<Placed>& slices, const TriangleWriter& writer)
{
  for (std::size_t i = 0; i < slices.size(); ++i)
  {
    this->FirstVertices.push_back(this->GetNumberOfVertices());
    if (slices[i].Whole)
    {
      writer.Add(slices[i].Outline, slices[i].Depth, this->Vertices);
      continue;
    }
    for (const Row& row : this->Rows)
    {
      const auto begin = static_cast<std::ptrdiff_t>(i > 0 ? row.Ends[i - 1] : 0);
      const auto end = static_cast<std::ptrdiff_t>(row.Ends[i]);
      this->Vertices.insert(
        this->Vertices.end(), row.Vertices.begin() + begin, row.Vertices.begin() + end);
    }
  }
  this->FirstVertices.push_back(this->GetNumberOfVertices());
}

void vtkTextureSliceGeometry::BuildPlane(
  const vtkTextureSliceView& view, const vtkTextureSliceEye& eye)
{
  std::vector<Plane> limits = MakeLimits(view);
  Plane inFront = eye.Depth;
  inFront[3] -= view.NearDepth;
  limits.push_back(inFront);
  this->NumberOfSlices = this->NumberOfPlanes = 1;
  // A sample stands for no length: of the vector along its ray, the direction alone counts.
  const TriangleWriter writer(view, eye, 1.0);
  writer.Add(Slicer(*view.Plane, std::move(limits)).Cut(0.0), 1.0, this->Vertices);
  this->FirstVertices = {0, this->GetNumberOfVertices()};
}

void vtkTextureSliceGeometry::Build(const vtkTextureSliceView& view)
{
  this->Vertices.clear();
  this->FirstVertices.clear();
  this->NumberOfSlices = 0;
  this->NumberOfPlanes = 0;
  this->DepthStep = 0.0;

  const vtkTextureSliceEye eye = MakeEye(view);
  const auto [nearest, farthest] = DepthRange(view, eye.Depth);
  if (!(nearest < farthest))
  {
    return;
  }
  if (view.Plane)
  {
    this->BuildPlane(view, eye);
    return;
  }
  const int count = CountSlices(view, farthest - nearest, eye.Direction);
  this->NumberOfPlanes = CountPlanes(view, eye, count, farthest - nearest);
  this->NumberOfSlices = this->NumberOfPlanes * std::max(1, view.Slabs);
  this->DepthStep = (farthest - nearest) / this->NumberOfPlanes;
  this->DataStep = this->DepthStep * DataLength(view, eye.Direction);
  this->ClipStep = MakeClipStep(view, eye, this->DepthStep);

  const vtkTextureSliceDensity density = MakeDensity(view, this->DataStep, this->NumberOfPlanes);
  const std::vector<Placed> slices =
    this->PlaceSlices(view, eye, nearest, density.Bricks != nullptr);
  const auto divided = [](const Placed& slice) { return !slice.Whole; };
  const int rows = std::any_of(slices.begin(), slices.end(), divided)
                     ? (view.Viewport[1] - 1) / vtkTextureSliceTiles::LargestTile + 1
                     : 0;
  this->Rows.resize(static_cast<std::size_t>(rows));
  const TriangleWriter writer(view, eye, this->DepthStep);
  // What is in a row of tiles hides nothing in another.
  vtkSMPTools::For(0, rows,
    [&](vtkIdType begin, vtkIdType end)
    {
      for (vtkIdType row = begin; row < end; ++row)
      {
        const int bottom = static_cast<int>(row) * vtkTextureSliceTiles::LargestTile;
        const int top = std::min(bottom + vtkTextureSliceTiles::LargestTile, view.Viewport[1]);
        vtkTextureSliceTiles tiles(*view.Occupancy, {0, bottom, view.Viewport[0], top}, density);
        DivideSlices(slices, tiles, writer, this->Rows[static_cast<std::size_t>(row)]);
      }
    });
  this->Join(slices, writer);
}

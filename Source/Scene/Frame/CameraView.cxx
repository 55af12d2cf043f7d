// SPDX-License-Identifier: BSD-3-Clause
#include "Scene/Frame/CameraView.h"

#include "Scene/Shapes/Shapes.h"
#include "nexrad/Geometry/Angles.h"

#include <vtkCamera.h>
#include <vtkClipConvexPolyData.h>
#include <vtkMath.h>
#include <vtkNew.h>
#include <vtkPlane.h>
#include <vtkPlaneCollection.h>
#include <vtkPolyData.h>
#include <vtkRenderer.h>
#include <vtkSmartPointer.h>
#include <vtkTessellatedBoxSource.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

namespace nexrad::scene
{
namespace
{

using Vector = std::array<double, 3>;

constexpr double viewAngle = 30.0; // degrees, vertical; VTK's default

struct Axes
{
  Vector right, up, back;
};

Axes AxesOf(const CameraView& view)
{
  const double sinA = std::sin(view.azimuth * RadiansPerDegree);
  const double cosA = std::cos(view.azimuth * RadiansPerDegree);
  const double sinT = std::sin(view.tilt * RadiansPerDegree);
  const double cosT = std::cos(view.tilt * RadiansPerDegree);
  return {{-cosA, sinA, 0.0}, {-sinA * sinT, -cosA * sinT, cosT}, {sinA * cosT, cosA * cosT, sinT}};
}

// What one direction of the picture (across or up) asks of the camera. A corner at the offset o
// along that direction, z nearer to the camera than the centre, is inside the picture's edge e when
// o − offset ≤ e·t·(distance − z), with t the tangent of the half angle of view. Every corner
// bounds offset + e·t·distance; `high` and `low` collect the bounds of the two edges.
struct Extent
{
  double lowEdge, highEdge; // the area's edges times t
  double low = std::numeric_limits<double>::max();
  double high = std::numeric_limits<double>::lowest();

  void Add(double along, double nearer)
  {
    high = std::max(high, along + highEdge * nearer);
    low = std::min(low, along + lowEdge * nearer);
  }
  double Distance() const { return (high - low) / (highEdge - lowEdge); }
  double Offset(double distance) const
  {
    return (high - highEdge * distance + low - lowEdge * distance) / 2.0;
  }
};

// Middle of the box about the points.
Vector MiddleOf(const std::vector<Vector>& points)
{
  Vector middle{};
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    const auto [least, most] = std::minmax_element(points.begin(), points.end(),
      [axis](const Vector& a, const Vector& b) { return a[axis] < b[axis]; });
    middle[axis] = ((*least)[axis] + (*most)[axis]) / 2.0;
  }
  return middle;
}

} // namespace

void PointCamera(vtkCamera* camera, const CameraView& view, const std::array<double, 6>& box,
  double aspect, const PictureArea& area)
{
  std::vector<Vector> corners;
  for (int corner = 0; corner < 8; ++corner)
  {
    corners.push_back(CornerOfBox(box, corner));
  }
  PointCamera(camera, view, corners, aspect, area);
}

void PointCamera(vtkCamera* camera, const CameraView& view, const std::vector<Vector>& points,
  double aspect, const PictureArea& area)
{
  const Axes axes = AxesOf(view);
  const Vector centre = MiddleOf(points);
  const double half = view.parallel ? 1.0 : std::tan(viewAngle / 2.0 * RadiansPerDegree);
  Extent across{area.left * half * aspect, area.right * half * aspect};
  Extent upward{area.bottom * half, area.top * half};
  double radius = 0.0;
  for (const Vector& scenePoint : points)
  {
    const Vector point = {
      scenePoint[0] - centre[0], scenePoint[1] - centre[1], scenePoint[2] - centre[2]};
    const double nearer = view.parallel ? 0.0 : vtkMath::Dot(point.data(), axes.back.data());
    across.Add(vtkMath::Dot(point.data(), axes.right.data()), nearer);
    upward.Add(vtkMath::Dot(point.data(), axes.up.data()), nearer);
    radius = std::max(radius, vtkMath::Norm(point.data()));
  }
  // Under parallel projection the same "distance" is half the height of the view.
  const double distance = std::max(across.Distance(), upward.Distance());
  const double alongRight = across.Offset(distance);
  const double alongUp = upward.Offset(distance);
  const double away = view.parallel ? 3.0 * radius : distance;
  Vector focus{};
  Vector position{};
  for (int axis = 0; axis < 3; ++axis)
  {
    focus[axis] = centre[axis] + alongRight * axes.right[axis] + alongUp * axes.up[axis];
    position[axis] = focus[axis] + away * axes.back[axis];
  }
  camera->SetFocalPoint(focus.data());
  camera->SetPosition(position.data());
  camera->SetViewUp(axes.up.data());
  camera->SetParallelProjection(view.parallel);
  camera->SetViewAngle(viewAngle);
  camera->SetParallelScale(distance);
  camera->Zoom(view.zoom);
}

void CentreOn(vtkCamera* camera, const Vector& point, double part)
{
  Vector position{};
  Vector focus{};
  Vector forward{};
  camera->GetPosition(position.data());
  camera->GetFocalPoint(focus.data());
  camera->GetDirectionOfProjection(forward.data());
  const Vector way = {point[0] - focus[0], point[1] - focus[1], point[2] - focus[2]};
  const double along = vtkMath::Dot(way.data(), forward.data());
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    const double sideways = part * (way[axis] - along * forward[axis]);
    position[axis] += sideways;
    focus[axis] += sideways;
  }
  camera->SetPosition(position.data());
  camera->SetFocalPoint(focus.data());
}

CameraView OnTheWayTo(const CameraView& view, double part)
{
  const double eased = part * part * (3.0 - 2.0 * part);
  CameraView there = view;
  there.zoom = std::pow(view.zoom, eased);
  // In the picture, what is looked at then moves as the zoom grows.
  constexpr double same = 1e-6;
  const double whole = 1.0 - 1.0 / view.zoom;
  there.nearness = std::abs(whole) > same ? (1.0 - 1.0 / there.zoom) / whole : eased;
  return there;
}

std::array<double, 2> RightOf(const CameraView& view)
{
  const Vector right = AxesOf(view).right;
  return {right[0], right[1]};
}

double DepthBefore(vtkCamera* camera, const double point[3])
{
  double way[3];
  vtkMath::Subtract(point, camera->GetPosition(), way);
  return vtkMath::Dot(way, camera->GetDirectionOfProjection());
}

double HalfHeightAt(vtkCamera* camera, const double point[3])
{
  return camera->GetParallelProjection() != 0
           ? camera->GetParallelScale()
           : DepthBefore(camera, point) *
               std::tan(vtkMath::RadiansFromDegrees(camera->GetViewAngle()) / 2.0);
}

namespace
{

vtkSmartPointer<vtkPlaneCollection> FrustumOf(vtkCamera* camera, double aspect)
{
  double coefficients[24];
  camera->GetFrustumPlanes(aspect, coefficients);
  auto planes = vtkSmartPointer<vtkPlaneCollection>::New();
  for (std::size_t i = 0; i < 6; ++i)
  {
    double* normal = coefficients + 4 * i; // it points into the frustum
    const double length = vtkMath::Normalize(normal);
    vtkNew<vtkPlane> plane;
    plane->SetNormal(normal);
    plane->Push(-normal[3] / length);
    planes->AddItem(plane);
  }
  return planes;
}

// What a camera shows of a box, as a solid; nullptr where that is nothing.
vtkSmartPointer<vtkPolyData> Clip(const std::array<double, 6>& box, vtkPlaneCollection* frustum)
{
  constexpr double rounding = 0.01; // scene units
  vtkNew<vtkTessellatedBoxSource> source;
  source->SetBounds(box.data());
  source->QuadsOn();
  vtkNew<vtkClipConvexPolyData> clip;
  clip->SetInputConnection(source->GetOutputPort());
  clip->SetPlanes(frustum);
  clip->Update();
  vtkPolyData* shown = clip->GetOutput();
  // The filter passes over a plane beyond which all lies.
  for (int i = 0; i < frustum->GetNumberOfItems(); ++i)
  {
    for (vtkIdType point = 0; point < shown->GetNumberOfPoints(); ++point)
    {
      if (frustum->GetItem(i)->EvaluateFunction(shown->GetPoint(point)) < -rounding)
      {
        return nullptr;
      }
    }
  }
  return shown;
}

} // namespace

std::optional<SeenPart> FindSeen(
  vtkRenderer* renderer, const std::array<int, 2>& size, const std::array<double, 6>& box)
{
  vtkNew<vtkCamera> camera;
  camera->DeepCopy(renderer->GetActiveCamera());
  camera->SetClippingRange(1.0, 1.0e5); // of the volume alone, wherever it is
  const auto shown = Clip(box, FrustumOf(camera, static_cast<double>(size[0]) / size[1]));
  if (shown == nullptr || shown->GetNumberOfPoints() == 0)
  {
    return std::nullopt;
  }
  SeenPart seen;
  std::copy_n(shown->GetBounds(), seen.faces.size(), seen.faces.begin());
  seen.pixel = std::numeric_limits<double>::infinity();
  for (vtkIdType i = 0; i < shown->GetNumberOfPoints(); ++i)
  {
    seen.pixel = std::min(seen.pixel, 2.0 * HalfHeightAt(camera, shown->GetPoint(i)) / size[1]);
  }
  return seen;
}

} // namespace nexrad::scene

// SPDX-License-Identifier: BSD-3-Clause
#include "Scene/Pointing/ViewRay.h"

#include <vtkCamera.h>
#include <vtkMath.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace nexrad::scene
{
namespace
{

// Half the height of the picture: as a tangent, or in scene units under parallel projection.
double HalfHeight(vtkCamera* camera)
{
  return camera->GetParallelProjection() != 0
           ? camera->GetParallelScale()
           : std::tan(vtkMath::RadiansFromDegrees(camera->GetViewAngle()) / 2.0);
}

} // namespace

ScenePoint ViewRay::At(double distance) const
{
  return {origin[0] + distance * direction[0], origin[1] + distance * direction[1],
    origin[2] + distance * direction[2]};
}

ViewRay RayThrough(
  vtkCamera* camera, const std::array<int, 2>& size, const std::array<double, 2>& pixel)
{
  ScenePoint forward{};
  ScenePoint up{};
  ScenePoint right{};
  camera->GetDirectionOfProjection(forward.data());
  camera->GetViewUp(up.data());
  vtkMath::Cross(forward.data(), up.data(), right.data());
  vtkMath::Normalize(right.data());
  vtkMath::Cross(right.data(), forward.data(), up.data());
  const double perPixel = 2.0 * HalfHeight(camera) / size[1];
  const double across = (pixel[0] - 0.5 * size[0]) * perPixel;
  const double upward = (pixel[1] - 0.5 * size[1]) * perPixel;
  ViewRay ray;
  camera->GetPosition(ray.origin.data());
  ray.direction = forward;
  ScenePoint& moved = camera->GetParallelProjection() != 0 ? ray.origin : ray.direction;
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    moved[axis] += across * right[axis] + upward * up[axis];
  }
  vtkMath::Normalize(ray.direction.data());
  return ray;
}

std::optional<double> DistanceToHeight(const ViewRay& ray, double z)
{
  const double distance = (z - ray.origin[2]) / ray.direction[2];
  return std::isfinite(distance) && distance >= 0.0 ? std::optional(distance) : std::nullopt;
}

std::optional<std::array<double, 2>> ClipToBox(const ViewRay& ray, const std::array<double, 6>& box)
{
  double enters = 0.0;
  double leaves = std::numeric_limits<double>::max();
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    const double lower = box[2 * axis] - ray.origin[axis];
    const double upper = box[2 * axis + 1] - ray.origin[axis];
    if (ray.direction[axis] == 0.0)
    {
      if (lower > 0.0 || upper < 0.0)
      {
        return std::nullopt;
      }
      continue;
    }
    const double first = lower / ray.direction[axis];
    const double second = upper / ray.direction[axis];
    enters = std::max(enters, std::min(first, second));
    leaves = std::min(leaves, std::max(first, second));
  }
  return enters <= leaves ? std::optional(std::array<double, 2>{enters, leaves}) : std::nullopt;
}

} // namespace nexrad::scene

// SPDX-License-Identifier: BSD-3-Clause
#include "Scene/Frame/SeenPart.h"

#include <vtkCamera.h>
#include <vtkClipConvexPolyData.h>
#include <vtkMath.h>
#include <vtkNew.h>
#include <vtkPlane.h>
#include <vtkPlaneCollection.h>
#include <vtkPolyData.h>
#include <vtkRenderer.h>
#include <vtkTessellatedBoxSource.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

namespace nexrad::scene
{
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

// Side of a pixel at a point.
double PixelAt(vtkCamera* camera, const double* point, int height)
{
  if (camera->GetParallelProjection() != 0)
  {
    return 2.0 * camera->GetParallelScale() / height;
  }
  double from[3];
  vtkMath::Subtract(point, camera->GetPosition(), from);
  const double depth = vtkMath::Dot(from, camera->GetDirectionOfProjection());
  return 2.0 * depth * std::tan(vtkMath::RadiansFromDegrees(0.5 * camera->GetViewAngle())) / height;
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
    seen.pixel = std::min(seen.pixel, PixelAt(camera, shown->GetPoint(i), size[1]));
  }
  return seen;
}

} // namespace nexrad::scene

// SPDX-License-Identifier: BSD-3-Clause
#include "Scene/Frame/SeenPart.h"

#include <vtkBox.h>
#include <vtkCamera.h>
#include <vtkMath.h>
#include <vtkMatrix4x4.h>
#include <vtkNew.h>
#include <vtkRenderer.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

namespace nexrad::scene
{
namespace
{

constexpr int raysAlong = 33; // of the picture, each way

using Point = std::array<double, 3>;

// How places of the scene and of a picture belong together: the picture is from −1 to 1 each way,
// and deep from −1 to 1.
class PictureProjection
{
public:
  PictureProjection(vtkCamera* camera, double aspect)
  {
    matrix->DeepCopy(camera->GetCompositeProjectionTransformMatrix(aspect, -1.0, 1.0));
    inverse->DeepCopy(matrix);
    inverse->Invert();
  }

  Point ToScene(const Point& place) const
  {
    const std::array<double, 4> point = Multiply(inverse, place);
    return {point[0] / point[3], point[1] / point[3], point[2] / point[3]};
  }

  bool Shows(const Point& point) const
  {
    const std::array<double, 4> place = Multiply(matrix, point);
    return place[3] > 0.0 && std::abs(place[0]) <= place[3] && std::abs(place[1]) <= place[3];
  }

private:
  static std::array<double, 4> Multiply(vtkMatrix4x4* by, const Point& point)
  {
    const double given[4] = {point[0], point[1], point[2], 1.0};
    std::array<double, 4> product{};
    by->MultiplyPoint(given, product.data());
    return product;
  }

  vtkNew<vtkMatrix4x4> matrix;
  vtkNew<vtkMatrix4x4> inverse;
};

// Side of a pixel at a point.
double PixelAt(vtkCamera* camera, const Point& point, int height)
{
  if (camera->GetParallelProjection() != 0)
  {
    return 2.0 * camera->GetParallelScale() / height;
  }
  const double* position = camera->GetPosition();
  const double* direction = camera->GetDirectionOfProjection();
  double depth = 0.0;
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    depth += (point[axis] - position[axis]) * direction[axis];
  }
  const double halfAngle = vtkMath::RadiansFromDegrees(0.5 * camera->GetViewAngle());
  return 2.0 * std::max(depth, 0.0) * std::tan(halfAngle) / height;
}

} // namespace

std::optional<SeenPart> FindSeen(
  vtkRenderer* renderer, const std::array<int, 2>& size, const std::array<double, 6>& box)
{
  constexpr double endless = std::numeric_limits<double>::infinity();
  vtkNew<vtkCamera> camera;
  camera->DeepCopy(renderer->GetActiveCamera());
  camera->SetClippingRange(1.0, 1.0e5); // of the volume alone, wherever it is
  const PictureProjection picture(camera, static_cast<double>(size[0]) / size[1]);
  SeenPart seen{{endless, -endless, endless, -endless}, endless};
  const auto add = [&](const Point& point)
  {
    for (const std::size_t axis : {0, 1})
    {
      seen.faces[2 * axis] = std::min(seen.faces[2 * axis], point[axis]);
      seen.faces[2 * axis + 1] = std::max(seen.faces[2 * axis + 1], point[axis]);
    }
    seen.pixel = std::min(seen.pixel, PixelAt(camera, point, size[1]));
  };
  for (int i = 0; i < raysAlong * raysAlong; ++i)
  {
    const double x = 2.0 * (i % raysAlong) / (raysAlong - 1) - 1.0;
    const double y = 2.0 * (i / raysAlong) / (raysAlong - 1) - 1.0;
    const Point from = picture.ToScene({x, y, -1.0});
    const Point to = picture.ToScene({x, y, 1.0});
    double t[2];
    Point in{};
    Point out{};
    int planes[2];
    if (vtkBox::IntersectWithLine(box.data(), from.data(), to.data(), t[0], t[1], in.data(),
          out.data(), planes[0], planes[1]) != 0)
    {
      add(in);
      add(out);
    }
  }
  for (std::size_t corner = 0; corner < 8; ++corner)
  {
    const Point point = {box[corner % 2], box[2 + corner / 2 % 2], box[4 + corner / 4]};
    if (picture.Shows(point))
    {
      add(point);
    }
  }
  if (!(seen.pixel < endless))
  {
    return std::nullopt;
  }
  for (const std::size_t axis : {0, 1}) // what lies between two rays
  {
    const double between = (seen.faces[2 * axis + 1] - seen.faces[2 * axis]) / (raysAlong - 1);
    seen.faces[2 * axis] = std::max(seen.faces[2 * axis] - between, box[2 * axis]);
    seen.faces[2 * axis + 1] = std::min(seen.faces[2 * axis + 1] + between, box[2 * axis + 1]);
  }
  return seen;
}

} // namespace nexrad::scene

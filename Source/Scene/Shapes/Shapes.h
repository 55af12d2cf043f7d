// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Scene/Shapes/Theme.h"

#include <vtkSmartPointer.h>

#include <array>
#include <vector>

class vtkActor;
class vtkPolyData;
class vtkProp;

namespace nexrad::scene
{

using ScenePoint = std::array<double, 3>;

/// Corner of a box (west, east, south, north, bottom, top): bit 0 of the index is east, bit 1
/// north, bit 2 top.
ScenePoint CornerOfBox(const std::array<double, 6>& box, int index);

/// Collects polylines and makes one actor of them.
class LineBuilder
{
public:
  LineBuilder();

  void Add(const std::vector<ScenePoint>& points);

  /// An unlit actor. `width` in pixels, `opacity` 0…1.
  vtkSmartPointer<vtkActor> MakeActor(
    const Colour& colour, double width, double opacity = 1.0) const;

private:
  vtkSmartPointer<vtkPolyData> lines;
};

/// The part of a segment that lies in a rectangle (west, east, south, north), as two fractions of
/// the segment from its first point. False when none does.
bool ClipToRectangle(const std::array<double, 2>& from, const std::array<double, 2>& to,
  const std::array<double, 4>& rectangle, double& enters, double& leaves);

/// A disc at a point of the scene with a thin rim, drawn over everything. `radius` in pixels.
vtkSmartPointer<vtkProp> MakeMarker(
  const ScenePoint& point, double radius, const Colour& colour, const Colour& rim);

} // namespace nexrad::scene

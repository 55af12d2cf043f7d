// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Scene/Elements/LineBuilder.h"

#include <vtkSmartPointer.h>

class vtkProp;

namespace nexrad::scene
{

/// A disc at a point of the scene with a thin rim, drawn over everything. `radius` in pixels.
vtkSmartPointer<vtkProp> MakeMarker(
  const ScenePoint& point, double radius, const Colour& colour, const Colour& rim);

} // namespace nexrad::scene

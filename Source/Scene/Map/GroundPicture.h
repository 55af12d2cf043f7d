// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Scene/Elements/Theme.h"
#include "Scene/Frame/SceneFrame.h"

#include <vtkSmartPointer.h>

class vtkImageData;

namespace nexrad::scene
{

/// Colours of the ground under a domain, from its south-western corner on: land with shaded relief,
/// and water. A domain outside of the embedded data, or without a map, has one colour. `longSide`:
/// texels along the longer side of the domain.
vtkSmartPointer<vtkImageData> MakeGroundPicture(
  const SceneFrame& frame, const Theme& theme, int longSide = 1024);

} // namespace nexrad::scene

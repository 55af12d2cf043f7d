// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Scene/Frame/CameraView.h"
#include "Scene/Frame/SceneFrame.h"

#include <vtkSmartPointer.h>

#include <vector>

class vtkProp;

namespace nexrad::scene
{

/// What tells sizes: the edges of the domain, a scale of heights in km above mean sea level at the
/// edge that is leftmost in the picture, a bar of a round length on the ground at the edge nearest
/// to the camera, and an N at the northern edge. `textSize` in pixels.
std::vector<vtkSmartPointer<vtkProp>> MakeScaleLayer(
  const SceneFrame& frame, const CameraView& view, int textSize);

/// The largest of 1, 2, 5, 10, 20, 50, … that is at most `limit` (above 0).
double RoundLength(double limit);

} // namespace nexrad::scene

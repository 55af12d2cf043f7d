// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Scene/Frame/CameraView.h"
#include "Scene/Frame/SceneFrame.h"
#include "Scene/Shapes/Letters.h"
#include "Scene/Shapes/Shapes.h"
#include "Scene/Shapes/Theme.h"

#include <array>
#include <vector>

namespace nexrad::scene
{

/// The scales, and the corners of all that they and the domain take.
struct ScaleLayer : SceneLayer
{
  std::vector<ScenePoint> outline;
};

/// What tells sizes: the edges of the ground and of the walls that are far from the camera; lines
/// of equal height on these walls where `walls`; a scale of heights in km above mean sea level at
/// the edge that is leftmost in the picture; and before the ground's edge nearest to the camera a
/// bar of a round length and an arrow to the north. `textSize` in pixels.
ScaleLayer MakeScaleLayer(
  const SceneFrame& frame, const CameraView& view, bool walls, int textSize, const Theme& theme);

/// The largest of 1, 2, 5, 10, 20, 50, … that is at most `limit` (above 0).
double RoundLength(double limit);

} // namespace nexrad::scene

// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Scene/Frame/CameraView.h"
#include "Scene/Frame/SceneFrame.h"
#include "Scene/Shapes/Letters.h"
#include "Scene/Shapes/Shapes.h"
#include "Scene/Shapes/Theme.h"

#include <memory>
#include <vector>

namespace nexrad::scene
{

/// Corner of a box (west, east, south, north, bottom, top): bit 0 of the index is east, bit 1
/// north, bit 2 top.
ScenePoint CornerOfBox(const std::array<double, 6>& box, int index);

/// Index of the corner of the ground that lies farthest along a direction of x and y.
int FarthestCorner(const std::array<double, 6>& box, const std::array<double, 2>& direction);

/// Round heights in the domain, in km above mean sea level: about three, and the ends where they
/// are round.
std::vector<double> RoundHeights(const SceneFrame& frame);

/// Edges of the domain: those of the ground, and of the two walls that are far from the camera; all
/// where not `open`.
std::unique_ptr<LineBuilder> MakeEdges(const SceneFrame& frame, const CameraView& view, bool open);

/// Lines at the round heights on the two far walls.
std::unique_ptr<LineBuilder> MakeHeightLines(const SceneFrame& frame, const CameraView& view);

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

// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Scene/Elements/LineBuilder.h"

#include <array>
#include <optional>

class vtkCamera;

namespace nexrad::scene
{

/// The line through one place of a picture, from the camera on.
struct ViewRay
{
  ScenePoint origin{};
  ScenePoint direction{}; ///< of length 1

  ScenePoint At(double distance) const;
};

/// The ray through a place of a picture of that size, both in pixels from the lower left corner.
ViewRay RayThrough(
  vtkCamera* camera, const std::array<int, 2>& size, const std::array<double, 2>& pixel);

/// How far along the ray it meets a horizontal plane; nothing where it does not.
std::optional<double> DistanceToHeight(const ViewRay& ray, double z);

/// The part of the ray within a box (west, east, south, north, bottom, top), as distances; nothing
/// where it misses the box.
std::optional<std::array<double, 2>> ClipToBox(
  const ViewRay& ray, const std::array<double, 6>& box);

} // namespace nexrad::scene

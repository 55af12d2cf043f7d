// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <optional>

class vtkRenderer;

namespace nexrad::scene
{

/// What a picture shows of a box of the scene.
struct SeenPart
{
  std::array<double, 4> faces = {0.0, 0.0, 0.0, 0.0}; ///< west, east, south, north, in scene units
  double pixel = 0.0; ///< side of a pixel where the box is nearest to the camera, in scene units
};

/// The part of a box (west, east, south, north, bottom, top) that a picture of `size` pixels shows
/// through a renderer's camera. Nothing where it shows none.
std::optional<SeenPart> FindSeen(
  vtkRenderer* renderer, const std::array<int, 2>& size, const std::array<double, 6>& box);

} // namespace nexrad::scene

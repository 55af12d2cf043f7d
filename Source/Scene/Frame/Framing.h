// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Scene/Elements/Label.h"
#include "Scene/Frame/CameraView.h"

#include <array>
#include <vector>

class vtkCamera;

namespace nexrad::scene
{

/// Where the points of a scene lie in a picture of that size.
class Projection
{
public:
  Projection(vtkCamera* camera, const std::array<int, 2>& size);

  /// In pixels from the lower left corner. Of a point behind the camera: far outside.
  std::array<double, 2> operator()(const ScenePoint& point) const;

  const std::array<int, 2>& Size() const { return size; }

private:
  std::array<double, 16> matrix;
  std::array<int, 2> size;
};

/// What a picture has to hold.
struct FramedScene
{
  std::vector<ScenePoint> outline; ///< corners of all that is drawn
  std::vector<Label> labels;       ///< words at its edges, each on the first of its sides
};

/// What may be filled with it.
struct FrameSpace
{
  std::array<int, 2> size = {0, 0};
  double right = 0.0;          ///< pixels; the colour bar stands to the right of it
  std::vector<PixelBox> taken; ///< by captions
};

/// Points the camera so that the scene is as large as it can be: the outline and its words within
/// the picture, and off the captions. Without a way to do so, as if the captions took the whole
/// width of the picture.
void FrameScene(vtkCamera* camera, const CameraView& view, const FramedScene& scene,
  const FrameSpace& space, TextPictures& pictures);

} // namespace nexrad::scene

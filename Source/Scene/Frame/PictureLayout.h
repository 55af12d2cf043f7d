// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Scene/Frame/CameraView.h"
#include "Scene/Shapes/Letters.h"

#include <array>
#include <optional>
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

/// A side for each label, in their order: the first on which it lies within the picture, over no
/// box that is taken, over no label before it and over no point of another label; where there is
/// none, that which covers the least. Nothing for an optional label that would cover any or come
/// nearer than its gap, whose dot would, that would come nearer than its room to another one with
/// room, or that would not lie wholly over the ground, whose corners are given one after the other.
std::vector<std::optional<LabelSide>> ChooseSides(const std::vector<Label>& labels,
  const std::array<ScenePoint, 4>& ground, const Projection& project, TextPictures& pictures,
  std::vector<PixelBox> taken);

} // namespace nexrad::scene

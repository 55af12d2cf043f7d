// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Scene/Elements/LineBuilder.h"
#include "Scene/Elements/TextPicture.h"

#include <string>
#include <vector>

class vtkProp;

namespace nexrad::scene
{

/// A word at a point of the scene.
struct Label
{
  std::string text;
  ScenePoint point{};
  TextStyle style;
  std::vector<LabelSide> sides; ///< where it may stand, the best first
  double gap = 0.0;             ///< pixels between the point and the letters
  bool optional = false;        ///< left out where it would lie over other letters
  double room = 0.0;            ///< pixels, distance of an optional label from others that have one
  double dot = 0.0;             ///< pixels, radius of a dot at the point; 0: none
};

/// A part of a scene, and the words that belong to it.
struct SceneLayer
{
  std::vector<vtkSmartPointer<vtkProp>> props;
  std::vector<Label> labels;
};

} // namespace nexrad::scene

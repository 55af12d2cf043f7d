// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Scene/Elements/ColourTable.h"

#include <vtkSmartPointer.h>

#include <array>
#include <string>

class vtkTextActor;

namespace nexrad::scene
{

/// Where a label stands beside its point.
enum class LabelSide
{
  Left,
  Right,
  Below
};

/// A word at a point of the scene, drawn over everything so that it stays legible. `size`: height
/// of the letters in pixels.
vtkSmartPointer<vtkTextActor> MakeLabel(const std::string& text, const std::array<double, 3>& point,
  int size, const Colour& colour, LabelSide side);

/// Text at a place of the picture: fractions of its width and height from the lower left corner.
/// `side` says on which side of the place the text stands.
vtkSmartPointer<vtkTextActor> MakeCaption(const std::string& text,
  const std::array<double, 2>& place, int size, const Colour& colour, LabelSide side);

} // namespace nexrad::scene

// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Scene/Elements/ColourTable.h"
#include "Scene/Elements/TextPicture.h"

#include <vtkSmartPointer.h>

#include <array>
#include <string>

class vtkTextActor;

namespace nexrad::scene
{

/// A word at a point of the scene that can be changed, drawn over everything so that it stays
/// legible. `size`: height of the letters in pixels. `side`: Left, Right or Below.
vtkSmartPointer<vtkTextActor> MakeLabel(const std::string& text, const std::array<double, 3>& point,
  int size, const Colour& colour, LabelSide side);

/// Text that can be changed at a place of the picture: fractions of its width and height from the
/// lower left corner. `side` says on which side of the place the text stands.
vtkSmartPointer<vtkTextActor> MakeCaption(const std::string& text,
  const std::array<double, 2>& place, int size, const Colour& colour, LabelSide side);

} // namespace nexrad::scene

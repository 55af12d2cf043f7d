// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Scene/Elements/TextPicture.h"
#include "Scene/Scales/ColourScale.h"

#include <vtkSmartPointer.h>

#include <array>
#include <vector>

class vtkProp;

namespace nexrad::scene
{

/// The colours of a scale as a column of boxes at the right edge of a picture of that size in
/// pixels, with the values at which they begin, or their labels, and the unit above. The boxes show
/// the colours of the scale exactly, within a thin line of the colour `edge`. Where the boxes are
/// lower than letters, some values are left out. A scale with ramps has boxes as high as they are
/// wide in values, and round values beside them.
std::vector<vtkSmartPointer<vtkProp>> MakeColourBar(const ColourScale& scale,
  const std::array<int, 2>& size, const TextStyle& style, const Colour& edge,
  TextPictures& pictures);

/// Where the bar and its unit begin, in pixels from the left.
double LeftOfColourBar(const ColourScale& scale, const std::array<int, 2>& size,
  const TextStyle& style, TextPictures& pictures);

} // namespace nexrad::scene

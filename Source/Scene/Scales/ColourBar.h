// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Scene/Scales/ColourScale.h"

#include <vtkSmartPointer.h>

#include <array>
#include <vector>

class vtkProp;

namespace nexrad::scene
{

/// The colours of a scale as a column of boxes at the right edge of a picture of that size in
/// pixels, with the values at which they begin, or their labels, and the unit above. The boxes show
/// the colours of the scale exactly.
std::vector<vtkSmartPointer<vtkProp>> MakeColourBar(
  const ColourScale& scale, const std::array<int, 2>& size, int textSize);

/// The bar's left edge as a fraction of the picture's width.
double LeftOfColourBar(const std::array<int, 2>& size, int textSize);

} // namespace nexrad::scene

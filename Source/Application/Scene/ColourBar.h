// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "ColourTable.h"

#include <vtkSmartPointer.h>

#include <array>
#include <vector>

class vtkProp;

namespace nexrad::scene
{

/// The colours of a table as a column of boxes at the right edge of a picture of that size in
/// pixels, with the values at which they begin and the unit above. The boxes show the colours of
/// the table exactly.
std::vector<vtkSmartPointer<vtkProp>> MakeColourBar(
  const ColourTable& table, const std::array<int, 2>& size, int textSize);

} // namespace nexrad::scene

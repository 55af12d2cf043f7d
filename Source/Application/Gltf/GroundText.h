// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vtkSmartPointer.h>

#include <array>
#include <string>

class vtkPolyData;

namespace nexrad::scene
{

/// A line of text that lies flat, in letters that an eye above it reads with north up: triangles in
/// the plane of that height. `corner`: lower left corner of the text, x and y; `size`: height of a
/// capital letter. All in the unit of the scene. ASCII alone.
vtkSmartPointer<vtkPolyData> MakeGroundText(
  const std::string& text, const std::array<double, 2>& corner, double height, double size);

} // namespace nexrad::scene

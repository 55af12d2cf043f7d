// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Scene/Elements/Theme.h"
#include "Scene/Frame/SceneFrame.h"

#include <vtkSmartPointer.h>

#include <vector>

class vtkImageData;

namespace nexrad::scene
{

/// Where a cell of a picture lies among coarser cells: those on both sides of its middle.
struct CellPlace
{
  int before = 0;
  int after = 0;
  float share = 0.0F; ///< of the later one
};

/// The places of all cells along an axis. `part`: of the length of the coarser cells, that which
/// the cells take.
std::vector<CellPlace> PlacesAmong(int cells, int coarser, double part = 1.0);

/// A value of row-by-row cells, `columns` in a row, at a place.
float ValueAt(
  const std::vector<float>& values, int columns, const CellPlace& x, const CellPlace& y);

/// Colours of the ground under a domain, from its south-western corner on: land with shaded relief,
/// and water. A domain outside of the embedded data, or without a map, has one colour. `longSide`:
/// texels along the longer side of the domain.
vtkSmartPointer<vtkImageData> MakeGroundPicture(
  const SceneFrame& frame, const Theme& theme, int longSide = 1024);

} // namespace nexrad::scene

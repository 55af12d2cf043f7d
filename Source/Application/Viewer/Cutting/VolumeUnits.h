// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QString>

class vtkImageData;

namespace nexrad::viewer
{

/// In what numbers of the window give places of a volume: km, or degrees on geographic axes.
struct HorizontalUnit
{
  double size = 1000.0; ///< in x and y of the volume
  double metres = 1.0;  ///< of one unit of x and y of the volume; of degrees, along a meridian
  QString suffix = " km";
  int decimals = 1; ///< of the numbers
};

/// `volume` may be nullptr.
HorizontalUnit HorizontalUnitOf(vtkImageData* volume);

} // namespace nexrad::viewer

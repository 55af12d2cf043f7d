// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Scene/Shapes/Letters.h"
#include "Scene/Shapes/Theme.h"

#include <vtkSmartPointer.h>

#include <array>
#include <optional>
#include <string>
#include <vector>

class vtkProp;

namespace nexrad::scene
{

/// What colours mean: the boxes of a colour bar.
struct ColourScale
{
  ColourTable bins;
  std::vector<std::string> labels;   ///< of each bin, beside its middle; empty: the value at which
                                     ///< it begins, beside its lower edge
  std::string unit;                  ///< above the bar
  std::string title;                 ///< of the picture
  double factor = 1.0;               ///< from the array's unit to that of the bins
  double offset = 0.0;               ///< added then, unit of the bins
  bool openBelow = false;            ///< values below the first bin have its colour, not none
  double step = 0.0;                 ///< between values beside ramps, unit of the bins; 0: any
  int decimals = -1;                 ///< of these values; -1: as many as it takes
  std::optional<Colour> rangeFolded; ///< of range-folded voxels; empty: the theme's
};

/// The scale of a moment, or of another array of that name, in a table's colours. Reflectivity
/// below the first bin has no colour; every value of the other moments has one.
ColourScale MomentScale(const std::string& array, const ColourTable& table);

/// The bin that holds a value of the array; -1 below the first, unless the scale is open there. The
/// last has no upper end.
int FindBin(const ColourScale& scale, double value);

/// The colour of a value of the array; nothing where it has no bin.
std::optional<Colour> ColourAt(const ColourScale& scale, double value);

/// The same scale with each ramp cut into bins of one colour each, for what draws no ramps.
ColourScale WithoutRamps(const ColourScale& scale);

/// A colour bar at the right edge of a picture.
struct ColourBar
{
  std::vector<vtkSmartPointer<vtkProp>> props;
  double left = 0.0; ///< pixels, where the bar and its unit begin
};

/// The colours of a scale as a column of boxes at the right edge of a picture of that size in
/// pixels, with the values at which they begin, or their labels, and the unit above. The boxes show
/// the colours of the scale exactly, within a thin line of the colour `edge`. Where the boxes are
/// lower than letters, some values are left out. A scale with ramps has boxes as high as they are
/// wide in values, and round values beside them.
ColourBar MakeColourBar(const ColourScale& scale, const std::array<int, 2>& size,
  const TextStyle& style, const Colour& edge, TextPictures& pictures);

} // namespace nexrad::scene

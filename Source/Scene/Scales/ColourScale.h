// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Scene/Elements/ColourTable.h"

#include <string>
#include <vector>

namespace nexrad::scene
{

/// What colours mean: the boxes of a colour bar.
struct ColourScale
{
  ColourTable bins;
  std::vector<std::string> labels; ///< of each bin, beside its middle; empty: the value at which
                                   ///< it begins, beside its lower edge
  std::string unit;                ///< above the bar
  std::string title;               ///< of the picture
  double factor = 1.0;             ///< from the array's unit to that of the bins
  bool openBelow = false;          ///< values below the first bin have its colour, not none
};

/// The scale of a moment, or of another array of that name, in a table's colours. Reflectivity
/// below the first bin has no colour; every value of the other moments has one.
ColourScale MomentScale(const std::string& array, const ColourTable& table);

/// The bin that holds a value of the array; -1 below the first, unless the scale is open there. The
/// last has no upper end.
int FindBin(const ColourScale& scale, double value);

} // namespace nexrad::scene

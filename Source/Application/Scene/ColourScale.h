// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "ColourTable.h"
#include "PlanView.h"

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

/// The scale for the map of one of a volume's arrays: for the moment, its own; for a companion,
/// one that reaches to the largest value of the map: age in minutes, weight, a colour for each
/// number of radars and for each of the volume's sites.
ColourScale ScaleFor(const PlanView& view, const std::string& array,
  const std::vector<std::string>& sites, const ColourScale& moment);

/// The bin that holds a value of the array; -1 below the first, unless the scale is open there. The
/// last has no upper end.
int FindBin(const ColourScale& scale, double value);

} // namespace nexrad::scene

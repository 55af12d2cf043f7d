// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <vector>

namespace nexrad::scene
{

/// Red, green and blue, 0…1.
using Colour = std::array<double, 3>;

/// One colour, from a value up to that of the next bin.
struct ColourBin
{
  double from = 0.0; ///< unit of what is shown
  Colour colour{};
};

/// At least two bins, their values ascending.
using ColourTable = std::vector<ColourBin>;

} // namespace nexrad::scene

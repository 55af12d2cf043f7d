// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <optional>
#include <vector>

namespace nexrad::scene
{

/// Red, green and blue, 0…1.
using Colour = std::array<double, 3>;

/// Where a ramp of colours ends, and in which.
struct ColourEnd
{
  double at = 0.0; ///< unit of what is shown
  Colour colour{};
};

/// One colour, or a ramp, from a value up to that of the next bin.
struct ColourBin
{
  double from = 0.0; ///< unit of what is shown
  Colour colour{};   ///< of a ramp, that at its beginning
  std::optional<ColourEnd> ramp = std::nullopt;
};

/// At least two bins, their values ascending.
using ColourTable = std::vector<ColourBin>;

} // namespace nexrad::scene

// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "nexrad/Grid/GridSpecification.h"
#include "nexrad/Model/Site.h"

#include <cstddef>
#include <string>
#include <vector>

namespace nexrad
{

/// The height of the ground below the columns of a grid, as far as the radars of a volume tell it:
/// that of the ground at the radar nearest to a column.
class GroundHeight
{
public:
  /// Mean sea level everywhere.
  GroundHeight() = default;
  /// From the radars of a volume. The site table has the ground at a radar that it knows; of
  /// another one the height of the antenna in `positions` stands for it. `positions` are those of
  /// `sites` in their order, or empty.
  GroundHeight(const GridSpecification& grid, const std::vector<std::string>& sites,
    const std::vector<Position>& positions);

  /// m above mean sea level, below a column of the grid (x fastest, then y); 0 where no radar's
  /// place is known.
  double Below(const GridSpecification& grid, std::size_t column) const;

private:
  struct Place
  {
    double x; // of the grid
    double y;
    double height; // m above mean sea level
  };
  std::vector<Place> places;
};

} // namespace nexrad

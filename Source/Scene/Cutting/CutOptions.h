// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "nexrad/Grid/PlaceUnit.h"
#include "nexrad/Products/VerticalSection.h"

#include <array>
#include <optional>

namespace nexrad::scene
{

/// A plane in the coordinates of the volume. The part of the volume towards which the normal points
/// is shown.
struct CutPlane
{
  std::array<double, 3> origin = {0.0, 0.0, 0.0}; ///< x and y as the volume has them, m upward
  std::array<double, 3> normal = {0.0, 1.0, 0.0}; ///< of any length but 0, in the same units

  bool operator==(const CutPlane& other) const
  {
    return origin == other.origin && normal == other.normal;
  }
};

/// Which part of the volume is shown, and where it is cut.
struct CutOptions
{
  PlaceUnit unit = PlaceUnit::OfVolume; ///< of x and y of all that follows
  /// What is shown: west, east, south, north in x and y of the volume, bottom and top in m above
  /// mean sea level; empty: all.
  std::optional<std::array<double, 6>> box;
  std::optional<CutPlane> plane;      ///< empty: none
  std::optional<SectionLine> section; ///< drawn on the ground with its ends A and B; empty: none

  bool operator==(const CutOptions& other) const
  {
    return unit == other.unit && box == other.box && plane == other.plane &&
           section == other.section;
  }
  bool operator!=(const CutOptions& other) const { return !(*this == other); }
};

} // namespace nexrad::scene

// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "nexrad/Grid/GridSpecification.h"

#include <string>

namespace nexrad
{

/// The unit of x and y of places that a user gives.
enum class PlaceUnit
{
  OfVolume, ///< that of the volume, whichever it is
  Metres,   ///< of volumes on projected axes
  Degrees   ///< of volumes on geographic axes
};

/// The unit of x and y on axes of this kind.
PlaceUnit PlaceUnitOf(GridAxes axes);

/// Throws Error where places are in another unit than x and y of their volume. `what` begins the
/// message: the places and their verb, as in "the section is".
void CheckPlaceUnit(PlaceUnit given, PlaceUnit ofVolume, const std::string& what);

} // namespace nexrad

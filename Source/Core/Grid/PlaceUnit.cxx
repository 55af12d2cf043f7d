// SPDX-License-Identifier: BSD-3-Clause
#include "nexrad/Grid/PlaceUnit.h"

#include "nexrad/System/Error.h"

namespace nexrad
{

PlaceUnit PlaceUnitOf(GridAxes axes)
{
  return axes == GridAxes::Geographic ? PlaceUnit::Degrees : PlaceUnit::Metres;
}

void CheckPlaceUnit(PlaceUnit given, PlaceUnit ofVolume, const std::string& what)
{
  if (given == PlaceUnit::OfVolume || given == ofVolume)
  {
    return;
  }
  throw Error(what + (ofVolume == PlaceUnit::Degrees
                         ? " in m or km, and the volume is on axes of longitude and latitude; "
                           "write degrees, as in -97.5deg"
                         : " in degrees, and the volume is in metres about its centre; write "
                           "lengths, as in -20km"));
}

} // namespace nexrad

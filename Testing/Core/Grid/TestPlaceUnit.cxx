// SPDX-License-Identifier: BSD-3-Clause
#include "nexrad/Grid/PlaceUnit.h"

#include "nexrad/System/Error.h"

#include <gtest/gtest.h>

namespace nexrad
{

TEST(PlaceUnit, PlacesAreInTheUnitOfTheirVolume)
{
  EXPECT_EQ(PlaceUnitOf(GridAxes::Projected), PlaceUnit::Metres);
  EXPECT_EQ(PlaceUnitOf(GridAxes::Geographic), PlaceUnit::Degrees);
  for (const PlaceUnit unit : {PlaceUnit::Metres, PlaceUnit::Degrees})
  {
    EXPECT_NO_THROW(CheckPlaceUnit(PlaceUnit::OfVolume, unit, "it is"));
    EXPECT_NO_THROW(CheckPlaceUnit(unit, unit, "it is"));
  }
  EXPECT_THROW(CheckPlaceUnit(PlaceUnit::Metres, PlaceUnit::Degrees, "it is"), Error);
  EXPECT_THROW(CheckPlaceUnit(PlaceUnit::Degrees, PlaceUnit::Metres, "it is"), Error);
}

} // namespace nexrad

// SPDX-License-Identifier: BSD-3-Clause
#include "nexrad/Simulation/StormField.h"

#include "nexrad/Simulation/StormDay.h"

#include <utility>

namespace nexrad
{

StormField::StormField(std::uint32_t seed)
  : storms(MakeStormDay(seed))
{
}

StormSnapshot StormField::At(Time time) const
{
  constexpr std::int64_t dayLength = 86'400'000;
  const std::int64_t sinceMidnight =
    ((time.time_since_epoch().count() % dayLength) + dayLength) % dayLength;
  const double seconds = static_cast<double>(sinceMidnight) / 1000.0;
  constexpr std::size_t usualElements = 256;
  std::vector<StormElement> elements;
  std::vector<StormVortex> vortices;
  elements.reserve(usualElements);
  for (const StormLife& storm : storms)
  {
    AddElements(storm, seconds, elements, vortices);
  }
  return {std::move(elements), std::move(vortices), seconds};
}

double StormField::Reflectivity(double longitude, double latitude, double height, Time time) const
{
  return this->At(time).Reflectivity(StormPlane::FromGeographic(longitude, latitude, height));
}

} // namespace nexrad

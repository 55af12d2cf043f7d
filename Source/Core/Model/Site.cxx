// SPDX-License-Identifier: BSD-3-Clause
#include "nexrad/Model/Site.h"

#include <cmath>
#include <tuple>

namespace nexrad
{

bool SiteKey::operator==(const SiteKey& other) const
{
  return std::tie(name, latitude, longitude) ==
         std::tie(other.name, other.latitude, other.longitude);
}

bool SiteKey::operator<(const SiteKey& other) const
{
  return std::tie(name, latitude, longitude) <
         std::tie(other.name, other.latitude, other.longitude);
}

SiteKey KeyOf(const Site& site)
{
  if (!site.name.empty() || !site.position)
  {
    return {site.name};
  }
  return {{}, site.position->latitude, site.position->longitude};
}

bool StandApart(const Site& a, const Site& b)
{
  constexpr double farthest = 2.0;            // km
  constexpr double kilometresADegree = 111.2; // of a great circle
  constexpr double radiansADegree = 0.017453292519943295;
  if (!a.position || !b.position)
  {
    return false;
  }
  const double north = a.position->latitude - b.position->latitude;
  const double east = std::remainder(a.position->longitude - b.position->longitude, 360.0) *
                      std::cos(a.position->latitude * radiansADegree);
  return std::hypot(north, east) * kilometresADegree > farthest;
}

} // namespace nexrad

// SPDX-License-Identifier: BSD-3-Clause
#include "nexrad/Model/SiteKey.h"

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

} // namespace nexrad

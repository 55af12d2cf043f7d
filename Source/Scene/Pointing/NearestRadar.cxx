// SPDX-License-Identifier: BSD-3-Clause
#include "Scene/Pointing/NearestRadar.h"

#include "nexrad/Grid/GridSpecification.h"
#include "nexrad/Model/SiteTable.h"

#include <cmath>

namespace nexrad::scene
{

std::optional<RadarPlace> FindNearestRadar(
  const std::vector<std::string>& sites, double latitude, double longitude)
{
  constexpr double degrees = 180.0 / 3.14159265358979323846;
  std::optional<RadarPlace> nearest;
  for (const std::string& name : sites)
  {
    const KnownSite* site = FindSite(name);
    if (site == nullptr)
    {
      continue;
    }
    GridSpecification about; // whose projection keeps distances and directions from the radar
    about.centreLatitude = site->position.latitude;
    about.centreLongitude = site->position.longitude;
    const auto [east, north] = about.FromGeographic(longitude, latitude);
    const double distance = std::hypot(east, north);
    if (!nearest || distance < nearest->distance)
    {
      const double azimuth = std::atan2(east, north) * degrees;
      nearest = RadarPlace{name, distance, azimuth < 0.0 ? azimuth + 360.0 : azimuth};
    }
  }
  return nearest;
}

} // namespace nexrad::scene

// SPDX-License-Identifier: BSD-3-Clause
#include "nexrad/Geometry/SiteGeoreference.h"

#include <GeographicLib/Geodesic.hpp>

namespace nexrad
{

SiteGeoreference::SiteGeoreference(const Position& site)
  : position(site)
{
}

std::array<double, 2> SiteGeoreference::Locate(const GroundDirection& direction) const
{
  double latitude = 0.0;
  double longitude = 0.0;
  GeographicLib::Geodesic::WGS84().Direct(position.latitude, position.longitude, direction.azimuth,
    direction.groundDistance, latitude, longitude);
  return {longitude, latitude};
}

GroundDirection SiteGeoreference::Look(double longitude, double latitude) const
{
  double distance = 0.0;
  double azimuth = 0.0;
  double azimuthThere = 0.0;
  GeographicLib::Geodesic::WGS84().Inverse(
    position.latitude, position.longitude, latitude, longitude, distance, azimuth, azimuthThere);
  return {azimuth < 0.0 ? azimuth + 360.0 : azimuth, distance};
}

} // namespace nexrad

// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "nexrad/Model/Site.h"

#include <array>

namespace nexrad
{

/// Where a point lies from a site: azimuth in degrees clockwise from north (0…360), distance along
/// the ground in m.
struct GroundDirection
{
  double azimuth = 0.0;
  double groundDistance = 0.0;
};

/// Places on the ground as seen from a radar: the geodesic on WGS84 that leaves the site at an
/// azimuth (Formulas B3). Exact to nanometres; about 1 µs a call, so callers with millions of
/// points keep what they got, or interpolate.
class SiteGeoreference
{
public:
  explicit SiteGeoreference(const Position& site);

  /// Longitude and latitude, degrees, of the point at `groundDistance` m in direction `azimuth`.
  std::array<double, 2> Locate(const GroundDirection& direction) const;

  /// Azimuth and distance of a point.
  GroundDirection Look(double longitude, double latitude) const;

private:
  Position position;
};

} // namespace nexrad

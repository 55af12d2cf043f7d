// SPDX-License-Identifier: BSD-3-Clause
#include "nexrad/Products/GroundHeight.h"

#include "nexrad/Geometry/Angles.h"
#include "nexrad/Model/SiteTable.h"

#include <algorithm>
#include <cmath>

namespace nexrad
{

GroundHeight::GroundHeight(const GridSpecification& grid, const std::vector<std::string>& sites,
  const std::vector<Position>& positions)
{
  const bool placed = positions.size() == sites.size();
  for (std::size_t i = 0; i < sites.size(); ++i)
  {
    const KnownSite* known = FindSite(sites[i]);
    if (known == nullptr && !placed)
    {
      continue;
    }
    const Position& position = placed ? positions[i] : known->position;
    const auto [x, y] = grid.FromGeographic(position.longitude, position.latitude);
    places.push_back({x, y, known != nullptr ? known->ground : position.altitude});
  }
}

double GroundHeight::Below(const GridSpecification& grid, std::size_t column) const
{
  const auto width = static_cast<std::size_t>(grid.dimensions[0]);
  const double x = grid.Coordinate(0, static_cast<int>(column % width));
  const double y = grid.Coordinate(1, static_cast<int>(column / width));
  // A degree of longitude is shorter than one of latitude.
  const double stretch = grid.axes == GridAxes::Geographic ? std::cos(y * RadiansPerDegree) : 1.0;
  const auto distance = [&](const Place& place)
  { return std::hypot(stretch * (place.x - x), place.y - y); };
  const auto nearest = std::min_element(places.begin(), places.end(),
    [&distance](const Place& a, const Place& b) { return distance(a) < distance(b); });
  return nearest == places.end() ? 0.0 : nearest->height;
}

} // namespace nexrad

// SPDX-License-Identifier: BSD-3-Clause
#include "nexrad/Velocity/WindProfile.h"

#include "nexrad/Geometry/Angles.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace nexrad
{

namespace
{

constexpr double widestGap = 2000.0; // m between levels

} // namespace

double Wind::Speed() const
{
  return std::hypot(east, north);
}

double Wind::Direction() const
{
  const double direction = std::atan2(-east, -north) / RadiansPerDegree;
  return direction < 0.0 ? direction + 360.0 : direction;
}

Wind WindFrom(double direction, double speed)
{
  return {-speed * std::sin(direction * RadiansPerDegree),
    -speed * std::cos(direction * RadiansPerDegree)};
}

std::optional<Wind> WindProfile::At(double height, double reach) const
{
  const auto above = std::lower_bound(levels.begin(), levels.end(), height,
    [](const ProfileLevel& level, double value) { return level.height < value; });
  const auto isNear = [&](const ProfileLevel& level)
  { return std::abs(level.height - height) <= reach; };
  if (above != levels.end() && above != levels.begin())
  {
    const ProfileLevel& low = *(above - 1);
    const double gap = above->height - low.height;
    if (gap <= widestGap)
    {
      const double share = (height - low.height) / gap;
      return Wind{low.wind.east + share * (above->wind.east - low.wind.east),
        low.wind.north + share * (above->wind.north - low.wind.north)};
    }
  }
  if (above != levels.end() && isNear(*above))
  {
    return above->wind;
  }
  if (above != levels.begin() && isNear(*(above - 1)))
  {
    return (above - 1)->wind;
  }
  return std::nullopt;
}

double WindProfile::DistanceTo(double height) const
{
  double nearest = std::numeric_limits<double>::infinity();
  for (const ProfileLevel& level : levels)
  {
    nearest = std::min(nearest, std::abs(level.height - height));
  }
  return nearest;
}

} // namespace nexrad

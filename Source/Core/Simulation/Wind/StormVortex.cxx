// SPDX-License-Identifier: BSD-3-Clause
#include "nexrad/Simulation/Wind/StormVortex.h"

#include <algorithm>
#include <cmath>

namespace nexrad
{

double StormVortex::RadiusAt(double z) const
{
  return std::max(coreRadius + widening * (z - level), coreRadius / 2.0);
}

void StormVortex::AddTo(WindVector& wind, const PlanePoint& point) const
{
  const PlanePoint axis = this->AxisAt(point.z);
  const double east = point.x - axis.x;
  const double north = point.y - axis.y;
  const double squared = east * east + north * north;
  if (squared >= Reach * Reach)
  {
    return;
  }
  const double radius = this->RadiusAt(point.z);
  double perMetre = 1.0 / radius; // of the distance from the axis
  if (squared > radius * radius)
  {
    const double rest = radius / Reach;
    perMetre = (radius / squared - rest / std::sqrt(squared)) / (1.0 - rest);
  }
  const double turning = perMetre * rotation.At(point.z);
  const double leaving = perMetre * (outflow.At(point.z) - inflow.At(point.z));
  wind.east += leaving * east - turning * north;
  wind.north += leaving * north + turning * east;
}

bool StormVortex::Touches(const Cylinder& cylinder, double distance) const
{
  const double bottom = cylinder.bottom;
  const double top = cylinder.top;
  if (!rotation.Touches(bottom, top) && !inflow.Touches(bottom, top) &&
      !outflow.Touches(bottom, top))
  {
    return false;
  }
  const PlanePoint axis = this->AxisAt((bottom + top) / 2.0);
  const double lean = std::hypot(tiltX, tiltY) * (top - bottom) / 2.0;
  const double reach = distance + cylinder.radius + lean;
  const double east = cylinder.x - axis.x;
  const double north = cylinder.y - axis.y;
  return east * east + north * north < reach * reach;
}

} // namespace nexrad

// SPDX-License-Identifier: BSD-3-Clause
#include "nexrad/Simulation/StormVortex.h"

#include <algorithm>
#include <cmath>

namespace nexrad
{

VortexSlice::VortexSlice(
  const PlanePoint& axis, double coreRadius, double turningSpeed, double leavingSpeed)
  : x(axis.x)
  , y(axis.y)
  , turning(turningSpeed)
  , leaving(leavingSpeed)
  , reachSquared(StormVortex::Reach * StormVortex::Reach)
  , coreSquared(coreRadius * coreRadius)
  , inCore(1.0 / coreRadius)
  , outside(coreRadius / (1.0 - coreRadius / StormVortex::Reach))
  , rest(outside / StormVortex::Reach)
{
}

double StormVortex::RadiusAt(double z) const
{
  return std::max(coreRadius + widening * (z - level), coreRadius / 2.0);
}

VortexSlice StormVortex::At(double z) const
{
  return {this->AxisAt(z), this->RadiusAt(z), rotation.At(z), outflow.At(z) - inflow.At(z)};
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
  const double lean = std::sqrt(tiltX * tiltX + tiltY * tiltY) * (top - bottom) / 2.0;
  const double reach = distance + cylinder.radius + lean;
  const double east = cylinder.x - axis.x;
  const double north = cylinder.y - axis.y;
  return east * east + north * north < reach * reach;
}

} // namespace nexrad

// SPDX-License-Identifier: BSD-3-Clause
#include "nexrad/Simulation/Wind/StormVortex.h"

#include <algorithm>
#include <cmath>

namespace nexrad
{

void VortexSlice::AddTo(WindVector& wind, double placeX, double placeY) const
{
  const double east = placeX - x;
  const double north = placeY - y;
  const double squared = east * east + north * north;
  constexpr double reach = StormVortex::Reach;
  if (squared >= reach * reach)
  {
    return;
  }
  double perMetre = 1.0 / coreRadius; // of the distance from the axis
  if (squared > coreRadius * coreRadius)
  {
    const double rest = coreRadius / reach;
    perMetre = (coreRadius / squared - rest / std::sqrt(squared)) / (1.0 - rest);
  }
  wind.east += perMetre * (leaving * east - turning * north);
  wind.north += perMetre * (leaving * north + turning * east);
}

double StormVortex::RadiusAt(double z) const
{
  return std::max(coreRadius + widening * (z - level), coreRadius / 2.0);
}

VortexSlice StormVortex::At(double z) const
{
  const PlanePoint axis = this->AxisAt(z);
  return {axis.x, axis.y, this->RadiusAt(z), rotation.At(z), outflow.At(z) - inflow.At(z)};
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

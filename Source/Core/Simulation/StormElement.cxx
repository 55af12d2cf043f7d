// SPDX-License-Identifier: BSD-3-Clause
#include "Simulation/StormElement.h"

#include <algorithm>
#include <cmath>

namespace nexrad
{

namespace
{

constexpr double brightBandGain = 6.0;    // dB, of melting snow over the rain below it
constexpr double brightBandDepth = 450.0; // m

double StratiformDrop(const StormElement& element, double above)
{
  double drop = above > 0.0 ? element.fall * above / element.depth : 0.0;
  if (std::abs(above) < 4.0 * brightBandDepth)
  {
    const double distance = above / brightBandDepth;
    drop -= brightBandGain * std::exp(-distance * distance);
  }
  return drop;
}

double VerticalDrop(const StormElement& element, double z)
{
  const double above = z - element.level;
  if (element.profile == VerticalProfile::Stratiform)
  {
    return StratiformDrop(element, above);
  }
  if (element.profile == VerticalProfile::Tower && above <= 0.0)
  {
    return 0.0;
  }
  const double distance = above / element.depth;
  return element.fall * distance * distance;
}

} // namespace

double StormElement::Reflectivity(const PlanePoint& point) const
{
  const double east = point.x - x - tiltX * (point.z - level);
  const double north = point.y - y - tiltY * (point.z - level);
  const double along = (east * alongX + north * alongY) / longAxis;
  const double across = (north * alongX - east * alongY) / shortAxis;
  const double distance = along * along + across * across;
  const double drop = edge * (plateau ? distance * distance : distance);
  const double value = peak - drop;
  // The vertical part is dearer, and adds at most the bright band.
  if (value + brightBandGain < MinimumReflectivity)
  {
    return value;
  }
  return value - VerticalDrop(*this, point.z);
}

ElementBounds BoundsOf(const StormElement& element)
{
  const bool stratiform = element.profile == VerticalProfile::Stratiform;
  const double strongest = element.peak + (stratiform ? brightBandGain : 0.0);
  const double margin = std::max(strongest - MinimumReflectivity, 0.0);
  const double distance = std::sqrt(margin / element.edge);
  const double reach = element.plateau ? std::sqrt(distance) : distance;
  const double height =
    element.depth * (stratiform ? margin / element.fall : std::sqrt(margin / element.fall));

  ElementBounds bounds{};
  bounds.top = element.level + height;
  bounds.bottom = element.profile == VerticalProfile::Layer ? element.level - height : 0.0;
  bounds.bottom = std::max(bounds.bottom, 0.0);
  const double middle = (bounds.top + bounds.bottom) / 2.0 - element.level;
  bounds.x = element.x + element.tiltX * middle;
  bounds.y = element.y + element.tiltY * middle;
  bounds.radius = reach * std::max(element.longAxis, element.shortAxis) +
                  std::hypot(element.tiltX, element.tiltY) * (bounds.top - bounds.bottom) / 2.0;
  return bounds;
}

} // namespace nexrad

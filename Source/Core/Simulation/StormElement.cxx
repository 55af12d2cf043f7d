// SPDX-License-Identifier: BSD-3-Clause
#include "nexrad/Simulation/StormElement.h"

#include <algorithm>
#include <cmath>

namespace nexrad
{

namespace
{

constexpr double brightBandDepth = 450.0; // m

double StratiformDrop(const StormElement& element, double above)
{
  double drop = above > 0.0 ? element.fall * above / element.depth : 0.0;
  const double distance = above / brightBandDepth;
  constexpr double negligible = 3.0;
  if (std::abs(distance) < negligible)
  {
    drop -= BrightBandGain * std::exp(-distance * distance);
  }
  return drop;
}

} // namespace

double StormElement::VerticalDrop(double z) const
{
  const double above = z - level;
  if (profile == VerticalProfile::Stratiform)
  {
    return StratiformDrop(*this, above);
  }
  if (profile == VerticalProfile::Tower && above <= 0.0)
  {
    return 0.0;
  }
  const double distance = above / depth;
  return fall * distance * distance;
}

ElementBounds BoundsOf(const StormElement& element)
{
  const bool stratiform = element.profile == VerticalProfile::Stratiform;
  const double strongest = element.peak + (stratiform ? BrightBandGain : 0.0);
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
  const double lean = std::hypot(element.tiltX, element.tiltY) * (bounds.top - bounds.bottom) / 2.0;
  bounds.x = element.x + element.tiltX * middle;
  bounds.y = element.y + element.tiltY * middle;
  bounds.alongX = element.alongX;
  bounds.alongY = element.alongY;
  bounds.halfLength = reach * element.longAxis + lean;
  bounds.halfWidth = reach * element.shortAxis + lean;
  return bounds;
}

} // namespace nexrad

// SPDX-License-Identifier: BSD-3-Clause
#include "nexrad/Geometry/Beam.h"

#include "nexrad/Geometry/Angles.h"
#include "nexrad/System/Error.h"

#include <cmath>
#include <limits>
#include <string>

namespace nexrad
{

BeamModel::BeamModel(double effectiveRadiusFactor)
  : effectiveRadius(effectiveRadiusFactor * EarthRadius)
{
  if (!(effectiveRadiusFactor > 0.0) || !std::isfinite(effectiveRadiusFactor))
  {
    throw Error("effective earth radius factor " + std::to_string(effectiveRadiusFactor) +
                ": must be positive (4/3 in the standard atmosphere)");
  }
}

BeamPoint BeamModel::Locate(double slantRange, double elevation) const
{
  const double up = slantRange * std::sin(elevation * RadiansPerDegree);
  const double along = slantRange * std::cos(elevation * RadiansPerDegree);
  // √(a² + d) − a loses its digits when d is small beside a²; d / (√(a² + d) + a) does not.
  const double d = slantRange * slantRange + 2.0 * effectiveRadius * up;
  const double distanceFromCentre = std::sqrt(effectiveRadius * effectiveRadius + d);
  return {d / (distanceFromCentre + effectiveRadius),
    effectiveRadius * std::atan2(along, effectiveRadius + up)};
}

BeamDirection BeamModel::Look(const BeamPoint& point) const
{
  const double arc = point.groundDistance / effectiveRadius;
  const double distanceFromCentre = effectiveRadius + point.height;
  const double sineOfHalf = std::sin(0.5 * arc);
  // (a + h)·cos(arc) − a, without the difference of two large numbers.
  const double up = point.height - 2.0 * distanceFromCentre * sineOfHalf * sineOfHalf;
  const double along = distanceFromCentre * std::sin(arc);
  const double squaredChord = 4.0 * effectiveRadius * distanceFromCentre * sineOfHalf * sineOfHalf;
  return {std::sqrt(point.height * point.height + squaredChord),
    std::atan2(up, along) / RadiansPerDegree};
}

double BeamModel::HeightOver(double groundDistance, double elevation) const
{
  const double arc = groundDistance / effectiveRadius;
  const double angle = elevation * RadiansPerDegree;
  const double denominator = std::cos(angle + arc);
  if (denominator <= 0.0)
  {
    return std::numeric_limits<double>::infinity();
  }
  // a·cos θ / cos(θ + arc) − a, with cos θ − cos(θ + arc) as a product of sines.
  return effectiveRadius * 2.0 * std::sin(angle + 0.5 * arc) * std::sin(0.5 * arc) / denominator;
}

double BeamModel::DistanceAt(double height, double elevation) const
{
  const double rise = effectiveRadius * std::sin(elevation * RadiansPerDegree);
  const double d = height * (2.0 * effectiveRadius + height);
  return this->Locate(std::sqrt(rise * rise + d) - rise, elevation).groundDistance;
}

} // namespace nexrad

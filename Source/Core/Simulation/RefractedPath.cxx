// SPDX-License-Identifier: BSD-3-Clause
#include "nexrad/Simulation/RefractedPath.h"

#include "nexrad/Geometry/Angles.h"

#include <algorithm>
#include <cmath>

namespace nexrad
{

namespace
{

constexpr double earthRadius = 6'371'000.0; // m
constexpr double rayStep = 0.1;             // degrees between traced rays
constexpr double rangeStep = 1'000.0;       // m between points of a ray

// Where a ray is, and its angle above the local horizon in rad.
struct RayState
{
  double height;
  double distance;
  double angle;
};

// Change of the state a metre along the ray; `gradient` is d(ln n)/dh in 1/m.
RayState Slope(const RayState& state, double gradient)
{
  const double cosine = std::cos(state.angle);
  const double radius = earthRadius + state.height;
  return {std::sin(state.angle), earthRadius * cosine / radius, cosine * (1.0 / radius + gradient)};
}

RayState Advance(const RayState& state, const RayState& slope, double step)
{
  return {state.height + step * slope.height, state.distance + step * slope.distance,
    state.angle + step * slope.angle};
}

// One step of the classical Runge-Kutta method.
RayState Step(const RayState& state, double gradient)
{
  const RayState first = Slope(state, gradient);
  const RayState second = Slope(Advance(state, first, rangeStep / 2.0), gradient);
  const RayState third = Slope(Advance(state, second, rangeStep / 2.0), gradient);
  const RayState fourth = Slope(Advance(state, third, rangeStep), gradient);
  RayState next = Advance(state, first, rangeStep / 6.0);
  next = Advance(next, second, rangeStep / 3.0);
  next = Advance(next, third, rangeStep / 3.0);
  return Advance(next, fourth, rangeStep / 6.0);
}

} // namespace

RefractedPath::RefractedPath(double effectiveRadiusFactor, double lowestElevation,
  double highestElevation, double farthestRange)
  : lowest(lowestElevation)
  , steps(static_cast<std::size_t>(std::ceil(farthestRange / rangeStep)) + 1)
  , rays(static_cast<std::size_t>(std::ceil((highestElevation - lowestElevation) / rayStep)) + 1)
{
  const double gradient = (1.0 / effectiveRadiusFactor - 1.0) / earthRadius;
  points.reserve(steps * rays);
  for (std::size_t ray = 0; ray < rays; ++ray)
  {
    RayState state{0.0, 0.0, (lowest + rayStep * static_cast<double>(ray)) * RadiansPerDegree};
    for (std::size_t step = 0; step < steps; ++step)
    {
      points.push_back({state.height, state.distance});
      state = Step(state, gradient);
    }
  }
}

PathPoint RefractedPath::At(double range, double elevation) const
{
  const double alongRays =
    std::clamp((elevation - lowest) / rayStep, 0.0, static_cast<double>(rays - 1));
  const double alongRange = std::clamp(range / rangeStep, 0.0, static_cast<double>(steps - 1));
  const std::size_t ray = std::min(static_cast<std::size_t>(alongRays), rays - 2);
  const std::size_t step = std::min(static_cast<std::size_t>(alongRange), steps - 2);
  const double up = alongRays - static_cast<double>(ray);
  const double out = alongRange - static_cast<double>(step);
  const PathPoint* lower = &points[ray * steps + step];
  const PathPoint* upper = lower + steps;
  const auto blend = [up, out](double nearLow, double farLow, double nearHigh, double farHigh)
  {
    return (1.0 - up) * ((1.0 - out) * nearLow + out * farLow) +
           up * ((1.0 - out) * nearHigh + out * farHigh);
  };
  return {blend(lower[0].height, lower[1].height, upper[0].height, upper[1].height),
    blend(lower[0].groundDistance, lower[1].groundDistance, upper[0].groundDistance,
      upper[1].groundDistance)};
}

} // namespace nexrad

// SPDX-License-Identifier: BSD-3-Clause
#include "nexrad/Simulation/StormWind.h"

#include "nexrad/Geometry/Angles.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace nexrad
{

namespace
{

constexpr double step = 500.0; // m between the heights of the table

// The wind blows away from where it comes from.
WindVector Components(const WindLevel& level)
{
  return {-level.speed * std::sin(level.direction * RadiansPerDegree),
    -level.speed * std::cos(level.direction * RadiansPerDegree)};
}

// The wind at equal steps of height, so that a height finds its levels without a search.
std::vector<WindVector> MakeTable()
{
  const std::vector<WindLevel>& levels = MeanWindLevels();
  std::vector<WindVector> table;
  for (std::size_t upper = 1; upper < levels.size(); ++upper)
  {
    const WindVector below = Components(levels[upper - 1]);
    const WindVector above = Components(levels[upper]);
    const double depth = levels[upper].height - levels[upper - 1].height;
    const auto steps = static_cast<int>(std::ceil(depth / step));
    for (int each = 0; each < steps; ++each)
    {
      const double up = each * step;
      table.push_back({below.east + (above.east - below.east) * up / depth,
        below.north + (above.north - below.north) * up / depth});
    }
  }
  table.push_back(Components(levels.back()));
  return table;
}

} // namespace

const std::vector<WindLevel>& MeanWindLevels()
{
  static const std::vector<WindLevel> levels = {{0.0, 155.0, 8.0}, {500.0, 165.0, 12.0},
    {1'000.0, 180.0, 16.0}, {2'000.0, 205.0, 18.0}, {3'000.0, 222.0, 21.0}, {4'500.0, 235.0, 26.0},
    {6'000.0, 242.0, 31.0}, {9'000.0, 248.0, 42.0}, {12'000.0, 252.0, 50.0},
    {14'000.0, 254.0, 44.0}, {18'000.0, 258.0, 25.0}};
  return levels;
}

WindVector MeanWind(double height)
{
  static const std::vector<WindVector> table = MakeTable();
  const double position =
    std::clamp(height / step, 0.0, static_cast<double>(table.size() - 1) - 1e-9);
  const auto below = static_cast<std::size_t>(position);
  const double share = position - static_cast<double>(below);
  const WindVector& low = table[below];
  const WindVector& high = table[below + 1];
  return {low.east + share * (high.east - low.east), low.north + share * (high.north - low.north)};
}

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

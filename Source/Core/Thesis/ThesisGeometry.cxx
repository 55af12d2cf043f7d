// SPDX-License-Identifier: BSD-3-Clause
#include "nexrad/Thesis/ThesisGeometry.h"

#include "nexrad/Geometry/Angles.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace nexrad
{

namespace
{

constexpr double earthRadius = 6'367'450.0; // m, Re of T1
constexpr double latticeSpacing = 5'000.0;  // m
constexpr double metresPerLatitude = earthRadius * RadiansPerDegree;

// Horizontal place in cells from the grid's lower faces.
std::array<double, 2> CellOf(
  const GridSpecification& grid, const Position& site, double east, double north)
{
  const std::array<double, 2> place = ThesisGeographic(site, east, north);
  const std::array<double, 2> point = grid.FromGeographic(place[0], place[1]);
  return {(point[0] - grid.origin[0]) / grid.spacing[0] + 0.5,
    (point[1] - grid.origin[1]) / grid.spacing[1] + 0.5};
}

} // namespace

ThesisRay::ThesisRay(double azimuth, double elevation, double siteAltitude)
  : cosElevation(std::cos(elevation * RadiansPerDegree))
  , sinElevation(std::sin(elevation * RadiansPerDegree))
  , eastPart(cosElevation * std::sin(azimuth * RadiansPerDegree))
  , northPart(cosElevation * std::cos(azimuth * RadiansPerDegree))
  , radiusAtSite(earthRadius + siteAltitude)
{
}

ThesisPoint ThesisRay::Locate(double slantRange) const
{
  const double up = radiusAtSite + slantRange * sinElevation;
  const double along = slantRange * cosElevation;
  return {slantRange * eastPart, slantRange * northPart,
    std::sqrt(up * up + along * along) - earthRadius};
}

std::array<double, 2> ThesisGeographic(const Position& site, double east, double north)
{
  const double metresPerLongitude = metresPerLatitude * std::cos(site.latitude * RadiansPerDegree);
  return {site.longitude + east / metresPerLongitude, site.latitude + north / metresPerLatitude};
}

ThesisCells::ThesisCells(const GridSpecification& grid, const Position& site, double radius,
  const std::optional<VoxelBlock>& part)
  : block(part.value_or(VoxelBlock::Of(grid)))
  , bottom(grid.origin[2] - 0.5 * grid.spacing[2])
  , cellHeight(grid.spacing[2])
  , reach(std::clamp(radius, latticeSpacing, LargestRadius))
  , nodesPerMetre(std::ceil(reach / latticeSpacing) / reach)
  , nodes(2 * static_cast<std::size_t>(std::ceil(reach / latticeSpacing)) + 1)
{
  lattice.reserve(nodes * nodes);
  for (std::size_t row = 0; row < nodes; ++row)
  {
    const double north = static_cast<double>(row) / nodesPerMetre - reach;
    for (std::size_t column = 0; column < nodes; ++column)
    {
      const double east = static_cast<double>(column) / nodesPerMetre - reach;
      lattice.push_back(CellOf(grid, site, east, north));
    }
  }
}

std::array<double, 2> ThesisCells::CellCoordinates(double east, double north) const
{
  const double column = (east + reach) * nodesPerMetre;
  const double row = (north + reach) * nodesPerMetre;
  const auto last = static_cast<double>(nodes - 1);
  if (!(column >= 0.0 && column <= last && row >= 0.0 && row <= last))
  {
    constexpr double nowhere = std::numeric_limits<double>::quiet_NaN();
    return {nowhere, nowhere};
  }
  const std::size_t i = std::min(static_cast<std::size_t>(column), nodes - 2);
  const std::size_t j = std::min(static_cast<std::size_t>(row), nodes - 2);
  const double u = column - static_cast<double>(i);
  const double v = row - static_cast<double>(j);
  const auto* corner = &lattice[j * nodes + i];
  std::array<double, 2> cell{};
  for (std::size_t axis = 0; axis < 2; ++axis)
  {
    const double lower = corner[0][axis] + u * (corner[1][axis] - corner[0][axis]);
    const double upper = corner[nodes][axis] + u * (corner[nodes + 1][axis] - corner[nodes][axis]);
    cell[axis] = lower + v * (upper - lower);
  }
  return cell;
}

std::ptrdiff_t ThesisCells::Find(const ThesisPoint& point) const
{
  const std::array<double, 2> cell = this->CellCoordinates(point.east, point.north);
  const double level = (point.altitude - bottom) / cellHeight;
  // Written so that NaN is outside too.
  const bool inside = cell[0] >= block.begin[0] && cell[0] < block.end[0] &&
                      cell[1] >= block.begin[1] && cell[1] < block.end[1] &&
                      level >= block.begin[2] && level < block.end[2];
  if (!inside)
  {
    return -1;
  }
  const auto x = static_cast<std::ptrdiff_t>(cell[0]) - block.begin[0];
  const auto y = static_cast<std::ptrdiff_t>(cell[1]) - block.begin[1];
  const auto z = static_cast<std::ptrdiff_t>(level) - block.begin[2];
  return (z * block.Size(1) + y) * block.Size(0) + x;
}

bool ThesisMayReach(
  const GridSpecification& grid, const VoxelBlock& block, const Position& site, double radius)
{
  // The samples lie within the square of the site's flat map, whose edges become curves on the
  // grid: their box, and a node's way more.
  const double reach = std::clamp(radius, latticeSpacing, ThesisCells::LargestRadius);
  const double margin = reach + latticeSpacing;
  const int steps = static_cast<int>(std::ceil(2.0 * margin / latticeSpacing));
  constexpr double infinity = std::numeric_limits<double>::infinity();
  std::array<double, 2> least = {infinity, infinity};
  std::array<double, 2> most = {-infinity, -infinity};
  for (int i = 0; i <= steps; ++i)
  {
    const double along = -margin + 2.0 * margin * i / steps;
    for (const auto& [east, north] : {std::pair(along, -margin), std::pair(along, margin),
           std::pair(-margin, along), std::pair(margin, along)})
    {
      const std::array<double, 2> cell = CellOf(grid, site, east, north);
      for (std::size_t axis = 0; axis < 2; ++axis)
      {
        least[axis] = std::min(least[axis], cell[axis]);
        most[axis] = std::max(most[axis], cell[axis]);
      }
    }
  }
  return least[0] < block.end[0] && most[0] >= block.begin[0] && least[1] < block.end[1] &&
         most[1] >= block.begin[1];
}

} // namespace nexrad

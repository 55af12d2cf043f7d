// SPDX-License-Identifier: BSD-3-Clause
#include "Gridding/SiteGeometry.h"

#include "Geometry/Angles.h"
#include "Geometry/SiteGeoreference.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace nexrad
{

namespace
{

// Half the sides of a box in the grid's units that holds the circle of `reach` about a latitude.
std::array<double, 2> HalfBox(const GridSpecification& grid, double latitude, double reach)
{
  if (grid.axes == GridAxes::Projected)
  {
    // Away from its centre the projection stretches across the line to it: 11 % at 5000 km.
    constexpr double stretch = 1.15;
    return {stretch * reach, stretch * reach};
  }
  constexpr double metresPerDegree = 110'500.0; // the least on WGS84
  const double north = reach / metresPerDegree;
  const double farthest = std::min(std::abs(latitude) + north, 89.0);
  return {north / std::cos(farthest * RadiansPerDegree), north};
}

// Metres east and north of the site, which vary smoothly over a grid, unlike the azimuth.
struct Offset
{
  double east = 0.0;
  double north = 0.0;
};

// Offsets at nodes that lie about 10 km apart over a box of columns, and bilinear between them.
class OffsetLattice
{
public:
  OffsetLattice(const GridSpecification& specification, const Position& site, const int (&first)[2],
    const int (&last)[2])
    : grid(specification)
  {
    const SiteGeoreference georeference(site);
    const double widest = grid.axes == GridAxes::Projected ? 10'000.0 : 0.1;
    for (int axis = 0; axis < 2; ++axis)
    {
      const double length = grid.spacing[axis] * std::max(last[axis] - 1 - first[axis], 1);
      cells[axis] = std::max(1, static_cast<int>(std::ceil(length / widest)));
      start[axis] = grid.Coordinate(axis, first[axis]);
      step[axis] = length / cells[axis];
    }
    for (int y = 0; y <= cells[1]; ++y)
    {
      for (int x = 0; x <= cells[0]; ++x)
      {
        nodes.push_back(this->Exact(georeference, start[0] + x * step[0], start[1] + y * step[1]));
      }
    }
  }

  Offset At(double x, double y) const
  {
    const auto [column, right] = this->Place(0, x);
    const auto [row, up] = this->Place(1, y);
    const auto width = static_cast<std::size_t>(cells[0] + 1);
    const Offset* below = nodes.data() + row * width + column;
    const Offset* above = below + width;
    const auto blend = [right = right, up = up](double a, double b, double c, double d)
    { return (1.0 - up) * (a + right * (b - a)) + up * (c + right * (d - c)); };
    return {blend(below[0].east, below[1].east, above[0].east, above[1].east),
      blend(below[0].north, below[1].north, above[0].north, above[1].north)};
  }

private:
  Offset Exact(const SiteGeoreference& georeference, double x, double y) const
  {
    const auto place = grid.ToGeographic(x, y);
    const GroundDirection direction = georeference.Look(place[0], place[1]);
    const double azimuth = direction.azimuth * RadiansPerDegree;
    return {
      direction.groundDistance * std::sin(azimuth), direction.groundDistance * std::cos(azimuth)};
  }

  // The cell and the part of it, from 0 to 1, at which a coordinate stands.
  std::pair<std::size_t, double> Place(int axis, double coordinate) const
  {
    const double place = (coordinate - start[axis]) / step[axis];
    const double cell = std::clamp(std::floor(place), 0.0, static_cast<double>(cells[axis] - 1));
    return {static_cast<std::size_t>(cell), place - cell};
  }

  const GridSpecification& grid;
  int cells[2] = {1, 1};
  double start[2] = {0.0, 0.0};
  double step[2] = {1.0, 1.0};
  std::vector<Offset> nodes;
};

ColumnDirection DirectionOf(const Offset& offset, double effectiveRadius)
{
  const double distance = std::hypot(offset.east, offset.north);
  const double azimuth = std::atan2(offset.east, offset.north) / RadiansPerDegree;
  const auto turned = static_cast<float>(azimuth < 0.0 ? azimuth + 360.0 : azimuth);
  return {turned < 360.0F ? turned : 0.0F,
    static_cast<float>(std::tan(0.5 * distance / effectiveRadius))};
}

} // namespace

SiteGeometry::SiteGeometry(
  const GridSpecification& grid, const Position& site, double reach, const BeamModel& beam)
{
  const auto centre = grid.FromGeographic(site.longitude, site.latitude);
  const auto half = HalfBox(grid, site.latitude, reach);
  for (int axis = 0; axis < 2; ++axis)
  {
    const double lowest = (centre[axis] - half[axis] - grid.origin[axis]) / grid.spacing[axis];
    const double highest = (centre[axis] + half[axis] - grid.origin[axis]) / grid.spacing[axis];
    const double size = grid.dimensions[axis];
    begin[axis] = static_cast<int>(std::clamp(std::ceil(lowest), 0.0, size));
    end[axis] = static_cast<int>(std::clamp(std::floor(highest) + 1.0, 0.0, size));
  }
  if (begin[0] >= end[0] || begin[1] >= end[1])
  {
    std::copy(begin, begin + 2, end);
    return;
  }
  const OffsetLattice lattice(grid, site, begin, end);
  columns.reserve(this->Width() * static_cast<std::size_t>(end[1] - begin[1]));
  for (int y = begin[1]; y < end[1]; ++y)
  {
    for (int x = begin[0]; x < end[0]; ++x)
    {
      columns.push_back(DirectionOf(
        lattice.At(grid.Coordinate(0, x), grid.Coordinate(1, y)), beam.EffectiveRadius()));
    }
  }
}

} // namespace nexrad

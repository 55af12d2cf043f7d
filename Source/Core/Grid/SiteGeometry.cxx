// SPDX-License-Identifier: BSD-3-Clause
#include "nexrad/Grid/SiteGeometry.h"

#include "nexrad/Geometry/Angles.h"
#include "nexrad/Geometry/SiteGeoreference.h"

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

// Offsets at nodes that lie about 10 km apart over a box of columns, and bilinear between them. The
// nodes are those of the whole box; only those about a part of it are computed.
class OffsetLattice
{
public:
  OffsetLattice(const GridSpecification& specification, const Position& site, const VoxelBlock& box,
    const VoxelBlock& part)
    : grid(specification)
  {
    const SiteGeoreference georeference(site);
    const double widest = grid.axes == GridAxes::Projected ? 10'000.0 : 0.1;
    for (int axis = 0; axis < 2; ++axis)
    {
      const double length = grid.spacing[axis] * std::max(box.Size(axis) - 1, 1);
      cells[axis] = std::max(1, static_cast<int>(std::ceil(length / widest)));
      start[axis] = grid.Coordinate(axis, box.begin[axis]);
      step[axis] = length / cells[axis];
      firstNode[axis] = this->PlaceOf(axis, grid.Coordinate(axis, part.begin[axis])).first;
      lastNode[axis] = this->PlaceOf(axis, grid.Coordinate(axis, part.end[axis] - 1)).first + 1;
    }
    for (int y = firstNode[1]; y <= lastNode[1]; ++y)
    {
      for (int x = firstNode[0]; x <= lastNode[0]; ++x)
      {
        nodes.push_back(this->Exact(georeference, start[0] + x * step[0], start[1] + y * step[1]));
      }
    }
  }

  // The cell of the lattice in which a coordinate stands, and the part of the cell before it, 0…1.
  using Place = std::pair<int, double>;

  Place PlaceOf(int axis, double coordinate) const
  {
    const double place = (coordinate - start[axis]) / step[axis];
    const double cell = std::clamp(std::floor(place), 0.0, static_cast<double>(cells[axis] - 1));
    return {static_cast<int>(cell), place - cell};
  }

  Offset At(const Place& x, const Place& y) const
  {
    const auto [column, right] = x;
    const auto [row, up] = y;
    const auto width = static_cast<std::size_t>(lastNode[0] - firstNode[0]) + 1;
    const Offset* below = nodes.data() + static_cast<std::size_t>(row - firstNode[1]) * width +
                          static_cast<std::size_t>(column - firstNode[0]);
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

  const GridSpecification& grid;
  int cells[2] = {1, 1};
  double start[2] = {0.0, 0.0};
  double step[2] = {1.0, 1.0};
  int firstNode[2] = {0, 0};
  int lastNode[2] = {0, 0};
  std::vector<Offset> nodes; // from the first to the last along both axes, x fastest
};

// The tangent of an angle, rad. Out to any gate its series is exact.
double TangentOf(double angle)
{
  const double s = angle * angle;
  return angle < 0.03
           ? angle *
               (1.0 + s * (1.0 / 3.0 + s * (2.0 / 15.0 + s * (17.0 / 315.0 + s * (62.0 / 2835.0)))))
           : std::tan(angle);
}

ColumnDirection DirectionOf(const Offset& offset, double effectiveRadius)
{
  const double distance = std::sqrt(offset.east * offset.east + offset.north * offset.north);
  const bool inReach = distance <= SiteGeometry::FarthestGate; // corners of a box are not
  const double azimuth = inReach ? std::atan2(offset.east, offset.north) / RadiansPerDegree : 0.0;
  const auto turned = static_cast<float>(azimuth < 0.0 ? azimuth + 360.0 : azimuth);
  return {turned < 360.0F ? turned : 0.0F,
    static_cast<float>(TangentOf(0.5 * distance / effectiveRadius))};
}

bool HasColumns(const VoxelBlock& box)
{
  return box.Size(0) > 0 && box.Size(1) > 0;
}

} // namespace

VoxelBlock SiteGeometry::ColumnsAbout(
  const GridSpecification& grid, const Position& site, double reach)
{
  const auto centre = grid.FromGeographic(site.longitude, site.latitude);
  const auto half = HalfBox(grid, site.latitude, reach);
  VoxelBlock box;
  for (int axis = 0; axis < 2; ++axis)
  {
    const double lowest = (centre[axis] - half[axis] - grid.origin[axis]) / grid.spacing[axis];
    const double highest = (centre[axis] + half[axis] - grid.origin[axis]) / grid.spacing[axis];
    const double size = grid.dimensions[axis];
    box.begin[axis] = static_cast<int>(std::clamp(std::ceil(lowest), 0.0, size));
    box.end[axis] = static_cast<int>(std::clamp(std::floor(highest) + 1.0, 0.0, size));
  }
  return box;
}

std::size_t SiteGeometry::MemoryBytesOf(
  const GridSpecification& grid, const Position& site, double reach, int rows)
{
  const VoxelBlock box = ColumnsAbout(grid, site, reach);
  const auto width = static_cast<std::size_t>(box.Size(0));
  const int most = rows > 0 ? rows : grid.dimensions[1];
  const auto height = static_cast<std::size_t>(std::min(most, box.Size(1)));
  return HasColumns(box) ? width * height * sizeof(ColumnDirection) : 0;
}

std::size_t SiteGeometry::MostMemoryBytes(const std::array<int, 3>& dimensions)
{
  return static_cast<std::size_t>(dimensions[0]) * static_cast<std::size_t>(dimensions[1]) *
         sizeof(ColumnDirection);
}

SiteGeometry::SiteGeometry(const GridSpecification& grid, const Position& site, double reach,
  const BeamModel& beam, const std::optional<VoxelBlock>& block)
{
  const VoxelBlock all = ColumnsAbout(grid, site, reach);
  const VoxelBlock wanted = block.value_or(VoxelBlock::Of(grid));
  VoxelBlock part;
  for (std::size_t axis = 0; axis < 2; ++axis)
  {
    part.begin[axis] = std::max(all.begin[axis], wanted.begin[axis]);
    part.end[axis] = std::min(all.end[axis], wanted.end[axis]);
  }
  if (!HasColumns(part))
  {
    return;
  }
  box = part;
  const OffsetLattice lattice(grid, site, all, box);
  std::vector<OffsetLattice::Place> places;
  for (int x = box.begin[0]; x < box.end[0]; ++x)
  {
    places.push_back(lattice.PlaceOf(0, grid.Coordinate(0, x)));
  }
  const double radius = beam.EffectiveRadius();
  columns.reserve(this->Width() * static_cast<std::size_t>(box.Size(1)));
  for (int y = box.begin[1]; y < box.end[1]; ++y)
  {
    const OffsetLattice::Place row = lattice.PlaceOf(1, grid.Coordinate(1, y));
    for (const OffsetLattice::Place& place : places)
    {
      columns.push_back(DirectionOf(lattice.At(place, row), radius));
      nearest = std::min(nearest, columns.back().halfTangent);
    }
  }
}

RadarView MakeRadarView(const GridSpecification& grid, const Position& radar, const RangeLoop& loop)
{
  RadarView view;
  ForEachArray(
    view, [&grid](const char*, std::vector<float>& values) { values.resize(grid.VoxelCount()); });
  const SiteGeoreference site(radar);
  const BeamModel beam;
  const auto width = static_cast<std::size_t>(grid.dimensions[0]);
  const auto height = static_cast<std::size_t>(grid.dimensions[1]);
  const int levels = grid.dimensions[2];
  RunEach(loop, height,
    [&](std::size_t y)
    {
      for (std::size_t x = 0; x < width; ++x)
      {
        const auto place = grid.ToGeographic(
          grid.Coordinate(0, static_cast<int>(x)), grid.Coordinate(1, static_cast<int>(y)));
        const GroundDirection direction = site.Look(place[0], place[1]);
        std::size_t voxel = y * width + x;
        for (int z = 0; z < levels; ++z, voxel += width * height)
        {
          const BeamDirection seen =
            beam.Look({grid.Coordinate(2, z) - radar.altitude, direction.groundDistance});
          const auto azimuth = static_cast<float>(direction.azimuth);
          view.azimuth[voxel] = azimuth < 360.0F ? azimuth : 0.0F; // what a float rounds up
          view.elevation[voxel] = static_cast<float>(seen.elevation);
          view.slantRange[voxel] = static_cast<float>(seen.slantRange);
        }
      }
    });
  return view;
}

} // namespace nexrad

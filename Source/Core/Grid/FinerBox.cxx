// SPDX-License-Identifier: BSD-3-Clause
#include "nexrad/Grid/FinerBox.h"

#include "nexrad/Geometry/Angles.h"
#include "nexrad/System/Error.h"

#include <algorithm>
#include <cmath>
#include <tuple>

namespace nexrad
{
namespace
{

struct Span
{
  double lower;
  double upper;
};

Span DomainAlong(const GridSpecification& domain, int axis)
{
  const double lower = domain.origin[axis] - 0.5 * domain.spacing[axis];
  return {lower, lower + domain.spacing[axis] * domain.dimensions[axis]};
}

Span PartAlong(const GridSpecification& domain, const BoxRequest& request, int axis)
{
  const Span whole = DomainAlong(domain, axis);
  return {std::max(whole.lower, request.faces[2 * axis]),
    std::min(whole.upper, request.faces[2 * axis + 1])};
}

// m that a unit of x or y is long in the middle of the box. On a sphere: voxels need no more exact
// size.
double LengthOfUnit(const GridSpecification& domain, int axis, const BoxRequest& request)
{
  if (domain.axes == GridAxes::Projected)
  {
    return 1.0;
  }
  const double middleY = 0.5 * (request.faces[2] + request.faces[3]);
  return axis == 0 ? MetresPerDegree * std::cos(middleY * RadiansPerDegree) : MetresPerDegree;
}

// Of the voxels of an axis those that a part of it covers by half, and at least one.
void CoverAlong(const GridSpecification& grid, int axis, const Span& part, VoxelBlock& block)
{
  const double lower = DomainAlong(grid, axis).lower;
  const auto voxelsTo = [&](double place)
  { return static_cast<int>(std::round((place - lower) / grid.spacing[axis])); };
  const int last = grid.dimensions[axis] - 1;
  block.begin[axis] = std::min(voxelsTo(part.lower), last);
  block.end[axis] = std::clamp(voxelsTo(part.upper), block.begin[axis] + 1, grid.dimensions[axis]);
}

// The part of the box that lies in the domain.
Span CheckedPart(const GridSpecification& domain, const BoxRequest& request, int axis)
{
  const Span part = PartAlong(domain, request, axis);
  if (!(part.upper > part.lower))
  {
    throw Error("the box does not lie over the domain");
  }
  return part;
}

// Voxels from the domain's lower face on.
void SetAxis(FinerBox& box, int axis, const Span& part, double spacing)
{
  constexpr double rounding = 1e-6; // of a voxel
  const Span domain = DomainAlong(box.grid, axis);
  const double count = (domain.upper - domain.lower) / spacing;
  box.grid.spacing[axis] = spacing;
  box.grid.origin[axis] = domain.lower + 0.5 * spacing;
  box.grid.dimensions[axis] = std::max(1, static_cast<int>(std::ceil(count - rounding)));
  CoverAlong(box.grid, axis, part, box.block);
}

} // namespace

bool operator==(const BoxRequest& a, const BoxRequest& b)
{
  return std::tie(a.faces, a.spacing, a.mostVoxels, a.followedFrom) ==
         std::tie(b.faces, b.spacing, b.mostVoxels, b.followedFrom);
}

BoxRequest CoarseDomain(const GridSpecification& domain)
{
  constexpr double height = 312.5;
  constexpr int columns = 128;
  const Span x = DomainAlong(domain, 0);
  const Span y = DomainAlong(domain, 1);
  return {{x.lower, x.upper, y.lower, y.upper}, std::max(height, domain.spacing[2]),
    std::min(columns, std::max(domain.dimensions[0], domain.dimensions[1]))};
}

std::array<double, 4> RoomToMove(const GridSpecification& domain, const BoxRequest& request)
{
  std::array<double, 4> room{};
  for (const int axis : {0, 1})
  {
    const Span whole = DomainAlong(domain, axis);
    const Span part = PartAlong(domain, request, axis);
    room[2 * axis] = std::min(0.0, whole.lower - part.lower);
    room[2 * axis + 1] = std::max(0.0, whole.upper - part.upper);
  }
  return room;
}

FinerBox MakeFinerBox(
  const GridSpecification& domain, const BoxRequest& request, const std::array<double, 2>& moved)
{
  if (!(request.spacing > 0.0) || request.mostVoxels < 1)
  {
    throw Error("the voxels of a box need a size above 0, and at least one along each axis");
  }
  FinerBox box;
  box.grid = domain;
  for (const int axis : {0, 1})
  {
    const Span part = CheckedPart(domain, request, axis);
    const double spacing = std::max(request.spacing / LengthOfUnit(domain, axis, request),
      (part.upper - part.lower) / request.mostVoxels);
    SetAxis(box, axis, part, spacing);
    // By whole voxels, as far as the grid reaches.
    int& begin = box.block.begin[axis];
    int& end = box.block.end[axis];
    const auto voxels = static_cast<int>(std::round(moved[axis] / spacing));
    const int way = std::clamp(voxels, -begin, box.grid.dimensions[axis] - end);
    begin += way;
    end += way;
  }
  SetAxis(box, 2, DomainAlong(domain, 2), request.spacing);
  return box;
}

VoxelBlock VoxelsOfBox(const GridSpecification& grid, const BoxRequest& request)
{
  VoxelBlock block = VoxelBlock::Of(grid);
  for (const int axis : {0, 1})
  {
    CoverAlong(grid, axis, CheckedPart(grid, request, axis), block);
    if (block.Size(axis) < 2) // which would have no thickness
    {
      block.end[axis] = std::min(block.begin[axis] + 2, grid.dimensions[axis]);
      block.begin[axis] = std::max(block.end[axis] - 2, 0);
    }
  }
  return block;
}

bool IsFinerThanAsked(const GridSpecification& grid, const BoxRequest& request)
{
  return 2.0 * grid.spacing[0] * LengthOfUnit(grid, 0, request) <= request.spacing;
}

} // namespace nexrad

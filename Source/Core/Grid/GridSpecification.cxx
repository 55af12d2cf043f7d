// SPDX-License-Identifier: BSD-3-Clause
#include "nexrad/Grid/GridSpecification.h"

#include "nexrad/Geometry/Angles.h"
#include "nexrad/System/Error.h"

#include <GeographicLib/AzimuthalEquidistant.hpp>

#include <algorithm>
#include <charconv>
#include <locale>
#include <sstream>

namespace nexrad
{

namespace
{

// The shortest text that reads back as the same number, independent of the locale.
std::string ToText(double value)
{
  std::array<char, 32> text{};
  const auto result = std::to_chars(text.data(), text.data() + text.size(), value);
  return {text.data(), result.ptr};
}

} // namespace

bool GridSpecification::operator==(const GridSpecification& other) const
{
  return dimensions == other.dimensions && origin == other.origin && spacing == other.spacing &&
         axes == other.axes && centreLatitude == other.centreLatitude &&
         centreLongitude == other.centreLongitude;
}

std::size_t GridSpecification::VoxelCount() const
{
  std::size_t count = 1;
  for (const int dimension : dimensions)
  {
    count *= dimension > 0 ? static_cast<std::size_t>(dimension) : 0;
  }
  return count;
}

std::string GridSpecification::Projection() const
{
  if (axes == GridAxes::Geographic)
  {
    return "+proj=longlat +datum=WGS84 +no_defs";
  }
  return "+proj=aeqd +lat_0=" + ToText(centreLatitude) + " +lon_0=" + ToText(centreLongitude) +
         " +datum=WGS84 +units=m +no_defs";
}

std::array<double, 2> GridSpecification::ToGeographic(double x, double y) const
{
  if (axes == GridAxes::Geographic)
  {
    return {AngleDifference(0.0, x), y};
  }
  double latitude = 0.0;
  double longitude = 0.0;
  const GeographicLib::AzimuthalEquidistant projection;
  projection.Reverse(centreLatitude, centreLongitude, x, y, latitude, longitude);
  return {longitude, latitude};
}

std::array<double, 2> GridSpecification::FromGeographic(double longitude, double latitude) const
{
  if (axes == GridAxes::Geographic)
  {
    // A grid across the antimeridian counts on past 180°: take the turn nearest to its middle.
    const double middle = origin[0] + 0.5 * spacing[0] * (dimensions[0] - 1);
    return {middle + AngleDifference(middle, longitude), latitude};
  }
  double x = 0.0;
  double y = 0.0;
  const GeographicLib::AzimuthalEquidistant projection;
  projection.Forward(centreLatitude, centreLongitude, latitude, longitude, x, y);
  return {x, y};
}

std::string GridText(const GridSpecification& grid)
{
  const bool projected = grid.axes == GridAxes::Projected;
  std::ostringstream text;
  text.imbue(std::locale::classic());
  text << grid.dimensions[0] << 'x' << grid.dimensions[1] << 'x' << grid.dimensions[2]
       << " voxels of " << grid.spacing[0] << " x " << grid.spacing[1]
       << (projected ? " x " : " degrees x ") << grid.spacing[2] << " m";
  if (projected)
  {
    text << " about " << grid.centreLatitude << ", " << grid.centreLongitude;
  }
  return text.str();
}

VoxelBlock VoxelBlock::Of(const GridSpecification& grid)
{
  VoxelBlock block;
  block.end = grid.dimensions;
  return block;
}

std::size_t VoxelBlock::VoxelCount() const
{
  std::size_t count = 1;
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    count *= static_cast<std::size_t>(std::max(0, this->Size(axis)));
  }
  return count;
}

bool operator==(const VoxelBlock& a, const VoxelBlock& b)
{
  return a.begin == b.begin && a.end == b.end;
}

GridSpecification PartOf(const GridSpecification& grid, const VoxelBlock& block)
{
  GridSpecification part = grid;
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    if (block.begin[axis] < 0 || block.Size(axis) < 1 || block.end[axis] > grid.dimensions[axis])
    {
      throw Error("voxels " + std::to_string(block.begin[axis]) + " to " +
                  std::to_string(block.end[axis] - 1) + " along axis " + std::to_string(axis) +
                  " of a grid that has " + std::to_string(grid.dimensions[axis]) +
                  ": a block needs a voxel or more, all in the grid");
    }
    part.dimensions[axis] = block.Size(axis);
    part.origin[axis] = grid.Coordinate(static_cast<int>(axis), block.begin[axis]);
  }
  return part;
}

PlaceUnit PlaceUnitOf(GridAxes axes)
{
  return axes == GridAxes::Geographic ? PlaceUnit::Degrees : PlaceUnit::Metres;
}

void CheckPlaceUnit(PlaceUnit given, PlaceUnit ofVolume, const std::string& what)
{
  if (given == PlaceUnit::OfVolume || given == ofVolume)
  {
    return;
  }
  throw Error(what + (ofVolume == PlaceUnit::Degrees
                         ? " in m or km, and the volume is on axes of longitude and latitude; "
                           "write degrees, as in -97.5deg"
                         : " in degrees, and the volume is in metres about its centre; write "
                           "lengths, as in -20km"));
}

} // namespace nexrad

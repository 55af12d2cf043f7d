// SPDX-License-Identifier: BSD-3-Clause
#include "nexrad/Grid/GridSpecification.h"

#include "nexrad/Geometry/Angles.h"

#include <GeographicLib/AzimuthalEquidistant.hpp>

#include <charconv>
#include <cmath>

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

} // namespace nexrad

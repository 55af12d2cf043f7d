// SPDX-License-Identifier: BSD-3-Clause
#include "nexrad/Grid/MakeGrid.h"

#include "nexrad/Geometry/Angles.h"
#include "nexrad/Geometry/SiteGeoreference.h"
#include "nexrad/System/Error.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>
#include <utility>

namespace nexrad
{

namespace
{

// No weather radar sees farther; a circle much larger no longer fits on a map.
constexpr double largestRange = 1'000'000.0; // m
constexpr int pointsOnCircle = 1440;

// A box of the horizontal axes, by its outer faces.
struct Box
{
  double west = std::numeric_limits<double>::infinity();
  double south = std::numeric_limits<double>::infinity();
  double east = -std::numeric_limits<double>::infinity();
  double north = -std::numeric_limits<double>::infinity();

  void Add(const std::array<double, 2>& point)
  {
    west = std::min(west, point[0]);
    south = std::min(south, point[1]);
    east = std::max(east, point[0]);
    north = std::max(north, point[1]);
  }
  std::array<double, 2> Centre() const { return {0.5 * (west + east), 0.5 * (south + north)}; }
};

double RangeOf(const GridRequest& request)
{
  return request.range.value_or(DefaultRange);
}

// Rounded to hundredths of a degree.
void SetCentre(GridSpecification& grid, const std::array<double, 2>& place)
{
  grid.centreLongitude = std::round(place[0] * 100.0) / 100.0;
  grid.centreLatitude = std::round(place[1] * 100.0) / 100.0;
}

template <typename... Parts>
[[noreturn]] void Refuse(const Parts&... parts)
{
  std::ostringstream text;
  (text << ... << parts);
  throw Error(text.str());
}

void CheckDimensions(const std::array<int, 3>& dimensions)
{
  double voxels = 1.0;
  for (const int dimension : dimensions)
  {
    if (dimension < 1)
    {
      Refuse("grid dimensions ", dimensions[0], "x", dimensions[1], "x", dimensions[2],
        ": each must be 1 or more");
    }
    voxels *= dimension;
  }
  if (voxels > std::numeric_limits<int>::max())
  {
    Refuse("grid dimensions ", dimensions[0], "x", dimensions[1], "x", dimensions[2],
      ": more voxels than ", std::numeric_limits<int>::max());
  }
}

void CheckBounds(const GeographicBounds& bounds)
{
  const bool longitudes = bounds.west < bounds.east && bounds.west >= -360.0 &&
                          bounds.east <= 360.0 && bounds.east - bounds.west <= 360.0;
  const bool latitudes =
    bounds.south < bounds.north && bounds.south >= -90.0 && bounds.north <= 90.0;
  if (!longitudes || !latitudes)
  {
    Refuse("bounds west ", bounds.west, ", south ", bounds.south, ", east ", bounds.east,
      ", north ", bounds.north,
      ": must be degrees with west < east and south < north (past the antimeridian, "
      "east counts on beyond 180)");
  }
}

void CheckRequest(const GridRequest& request)
{
  CheckDimensions(request.dimensions);
  if (!std::isfinite(request.bottom) || !std::isfinite(request.top) ||
      request.bottom >= request.top)
  {
    Refuse(
      "heights ", request.bottom, " m to ", request.top, " m: the lower must be below the upper");
  }
  if (request.bounds)
  {
    CheckBounds(*request.bounds);
    constexpr double widest = 180.0; // degrees; farther from its centre the projection turns over
    const double width = request.bounds->east - request.bounds->west;
    if (request.axes == GridAxes::Projected && width > widest)
    {
      Refuse("bounds from west ", request.bounds->west, " to east ", request.bounds->east,
        ": a grid in metres is at most ", widest, " degrees wide");
    }
  }
  else if (!(RangeOf(request) > 0.0) || RangeOf(request) > largestRange)
  {
    Refuse("range ", RangeOf(request), " m: must be above 0 and at most ", largestRange, " m");
  }
}

// Middle of the sites on the sphere, which has no seam at the antimeridian.
std::array<double, 2> MiddleOf(const std::vector<Position>& sites)
{
  std::array<double, 3> sum = {0.0, 0.0, 0.0};
  for (const Position& site : sites)
  {
    const double latitude = site.latitude * RadiansPerDegree;
    const double longitude = site.longitude * RadiansPerDegree;
    sum[0] += std::cos(latitude) * std::cos(longitude);
    sum[1] += std::cos(latitude) * std::sin(longitude);
    sum[2] += std::sin(latitude);
  }
  return {std::atan2(sum[1], sum[0]) / RadiansPerDegree,
    std::atan2(sum[2], std::hypot(sum[0], sum[1])) / RadiansPerDegree};
}

// Longitudes and latitudes of the circles of `range` about the sites. The corners of the polygon
// lie so far outside that its sides touch the circle: the box of the points holds the circle.
std::vector<std::array<double, 2>> PointsOnCircles(const std::vector<Position>& sites, double range)
{
  const double radius = range / std::cos(Pi / pointsOnCircle);
  std::vector<std::array<double, 2>> points;
  points.reserve(sites.size() * pointsOnCircle);
  for (const Position& site : sites)
  {
    const SiteGeoreference georeference(site);
    for (int i = 0; i < pointsOnCircle; ++i)
    {
      points.push_back(georeference.Locate({360.0 * i / pointsOnCircle, radius}));
    }
  }
  return points;
}

// The sites whose circles may touch a side of the box of all circles. The projection shortens no
// way, and at an angle from its centre it stretches none by more than angle/sin(angle).
std::vector<Position> OutermostSites(
  const GridSpecification& projected, const std::vector<Position>& sites, double range)
{
  Box middles;
  std::vector<std::array<double, 2>> places;
  double farthest = range;
  for (const Position& site : sites)
  {
    places.push_back(projected.FromGeographic(site.longitude, site.latitude));
    middles.Add(places.back());
    farthest = std::max(farthest, std::hypot(places.back()[0], places.back()[1]) + range);
  }
  constexpr double rounding = 0.01; // what the earth differs from a sphere, and points from circles
  const double angle = farthest / MetresPerDegree * RadiansPerDegree;
  if (angle >= 0.5 * Pi)
  {
    return sites;
  }
  const double margin = (angle / std::sin(angle) - 1.0 + 2.0 * rounding) * range;
  std::vector<Position> outermost;
  for (std::size_t i = 0; i < sites.size(); ++i)
  {
    const auto [x, y] = places[i];
    if (x <= middles.west + margin || x >= middles.east - margin || y <= middles.south + margin ||
        y >= middles.north - margin)
    {
      outermost.push_back(sites[i]);
    }
  }
  return outermost;
}

// Points along the edges of geographic bounds; on a projection the edges are curved.
std::vector<std::array<double, 2>> PointsOnBounds(const GeographicBounds& bounds)
{
  constexpr int steps = 256;
  std::vector<std::array<double, 2>> points;
  for (int i = 0; i <= steps; ++i)
  {
    const double fraction = static_cast<double>(i) / steps;
    const double longitude = bounds.west + fraction * (bounds.east - bounds.west);
    const double latitude = bounds.south + fraction * (bounds.north - bounds.south);
    points.push_back({longitude, bounds.south});
    points.push_back({longitude, bounds.north});
    points.push_back({bounds.west, latitude});
    points.push_back({bounds.east, latitude});
  }
  return points;
}

// The box of the points on the projected axes; whole metres outwards, so that the faces read well.
Box ProjectedBox(const GridSpecification& grid, const std::vector<std::array<double, 2>>& points)
{
  Box box;
  for (const auto& point : points)
  {
    box.Add(grid.FromGeographic(point[0], point[1]));
  }
  box.west = std::floor(box.west);
  box.south = std::floor(box.south);
  box.east = std::ceil(box.east);
  box.north = std::ceil(box.north);
  return box;
}

// The box depends on the projection's centre and the centre on the box. A centre moves the box by
// far less than it moved itself, so a few rounds settle; where two centres alternate at the
// rounding's edge, either is good.
Box BoxAboutSites(
  GridSpecification& grid, const std::vector<Position>& sites, const GridRequest& request)
{
  GridSpecification projected;
  SetCentre(projected, MiddleOf(sites));
  const double range = RangeOf(request);
  std::vector<Position> outermost;
  std::vector<std::array<double, 2>> points; // on the circles about these
  const auto boxOfCircles = [&]
  {
    if (std::vector<Position> now = OutermostSites(projected, sites, range); now != outermost)
    {
      points = PointsOnCircles(now, range);
      outermost = std::move(now);
    }
    return ProjectedBox(projected, points);
  };
  Box box = boxOfCircles();
  for (int round = 0; round < 8; ++round)
  {
    const std::array<double, 2> before = {projected.centreLongitude, projected.centreLatitude};
    const std::array<double, 2> centre = box.Centre();
    SetCentre(projected, projected.ToGeographic(centre[0], centre[1]));
    if (before[0] == projected.centreLongitude && before[1] == projected.centreLatitude)
    {
      break;
    }
    box = boxOfCircles();
  }
  grid.centreLongitude = projected.centreLongitude;
  grid.centreLatitude = projected.centreLatitude;
  if (grid.axes == GridAxes::Projected)
  {
    return box;
  }
  Box degrees;
  for (const auto& point : PointsOnCircles(sites, range))
  {
    const double turn = AngleDifference(grid.centreLongitude, point[0]);
    degrees.Add({grid.centreLongitude + turn, point[1]});
  }
  return degrees;
}

Box BoxOfBounds(GridSpecification& grid, const GeographicBounds& bounds)
{
  const Box degrees = {bounds.west, bounds.south, bounds.east, bounds.north};
  const std::array<double, 2> centre = degrees.Centre();
  SetCentre(grid, {AngleDifference(0.0, centre[0]), centre[1]});
  return grid.axes == GridAxes::Geographic ? degrees : ProjectedBox(grid, PointsOnBounds(bounds));
}

} // namespace

GridSpecification MakeGrid(const GridRequest& request, const std::vector<Position>& sites)
{
  CheckRequest(request);
  if (sites.empty() && !request.bounds)
  {
    Refuse("no radar with a known position: give the bounds of the grid");
  }
  GridSpecification grid;
  grid.dimensions = request.dimensions;
  grid.axes = request.axes;
  const Box box =
    request.bounds ? BoxOfBounds(grid, *request.bounds) : BoxAboutSites(grid, sites, request);
  const std::array<double, 3> lower = {box.west, box.south, request.bottom};
  const std::array<double, 3> upper = {box.east, box.north, request.top};
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    grid.spacing[axis] = (upper[axis] - lower[axis]) / grid.dimensions[axis];
    grid.origin[axis] = lower[axis] + 0.5 * grid.spacing[axis];
  }
  return grid;
}

} // namespace nexrad

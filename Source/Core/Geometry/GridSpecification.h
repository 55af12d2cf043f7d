// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Model/Site.h"

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace nexrad
{

/// What x and y of a grid mean. z is always m above mean sea level.
enum class GridAxes
{
  Projected, ///< m east and north of the centre, azimuthal equidistant projection of WGS84
  Geographic ///< degrees of longitude and latitude, as the thesis has them
};

/// Outer faces of a box, degrees.
struct GeographicBounds
{
  double west, south, east, north;
};

/// A regular grid of voxels. A voxel's value belongs to its centre: `origin` is the centre of the
/// first voxel, the grid's lower faces lie half a spacing before it.
struct GridSpecification
{
  std::array<int, 3> dimensions = {256, 256, 128}; ///< voxels along x, y, z
  std::array<double, 3> origin = {0.0, 0.0, 0.0};  ///< m, or degrees for Geographic x and y
  std::array<double, 3> spacing = {1.0, 1.0, 1.0}; ///< m, or degrees
  GridAxes axes = GridAxes::Projected;
  double centreLatitude = 0.0;  ///< degrees, of the projection
  double centreLongitude = 0.0; ///< degrees

  std::size_t VoxelCount() const;
  /// Centre of voxel i along an axis (0 x, 1 y, 2 z).
  double Coordinate(int axis, int index) const { return origin[axis] + spacing[axis] * index; }
  /// PROJ string of the x and y axes.
  std::string Projection() const;
  /// Longitude and latitude in degrees of a point (x, y) of the grid.
  std::array<double, 2> ToGeographic(double x, double y) const;
  /// The point (x, y) of a longitude and latitude.
  std::array<double, 2> FromGeographic(double longitude, double latitude) const;
};

/// m, to which the velocity of a weather radar of the network reaches; beyond, beams are too high
/// to show much.
constexpr double DefaultRange = 230'000.0;

/// What a user asks for; the rest follows from the sites.
struct GridRequest
{
  std::array<int, 3> dimensions = {256, 256, 128};
  double range = DefaultRange; ///< m, radius of the circle about each site that the box must hold
  double bottom = 0.0;         ///< m above mean sea level, lower face
  double top = 20'000.0;       ///< m above mean sea level, upper face
  std::optional<GeographicBounds> bounds; ///< replaces the box about the sites
  GridAxes axes = GridAxes::Projected;
};

/// The grid of a request: the box round the circles about all sites (or `bounds`), its centre
/// rounded to 0.01° as the projection's. Throws Error for no sites with a position and no bounds,
/// bounds or heights inside out, dimensions below 1 or more voxels than an int can count, or a
/// range that is not positive.
GridSpecification MakeGrid(const GridRequest& request, const std::vector<Position>& sites);

} // namespace nexrad

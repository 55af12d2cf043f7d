// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstddef>
#include <string>

namespace nexrad
{

/// What x and y of a grid mean. z is always m above mean sea level.
enum class GridAxes
{
  Projected, ///< m east and north of the centre, azimuthal equidistant projection of WGS84
  Geographic ///< degrees of longitude and latitude, as the thesis has them
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

  bool operator==(const GridSpecification& other) const;
  bool operator!=(const GridSpecification& other) const { return !(*this == other); }

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

/// A grid for a message: "64x64x32 voxels of 7187.5 x 7187.5 x 625 m about 38.81, -94.26", the
/// latitude and longitude of the projection's centre in degrees.
std::string GridText(const GridSpecification& grid);

/// A box of voxels of a grid: those of which each index lies in begin ≤ index < end.
struct VoxelBlock
{
  std::array<int, 3> begin = {0, 0, 0}; ///< along x, y, z
  std::array<int, 3> end = {0, 0, 0};

  /// All voxels of a grid.
  static VoxelBlock Of(const GridSpecification& grid);

  int Size(std::size_t axis) const { return end[axis] - begin[axis]; }
  std::size_t VoxelCount() const;
};

bool operator==(const VoxelBlock& a, const VoxelBlock& b);
inline bool operator!=(const VoxelBlock& a, const VoxelBlock& b)
{
  return !(a == b);
}

/// The block as a grid of its own. Throws Error when the block has no voxels, or some outside the
/// grid.
GridSpecification PartOf(const GridSpecification& grid, const VoxelBlock& block);

/// The unit of x and y of places that a user gives.
enum class PlaceUnit
{
  OfVolume, ///< that of the volume, whichever it is
  Metres,   ///< of volumes on projected axes
  Degrees   ///< of volumes on geographic axes
};

/// The unit of x and y on axes of this kind.
PlaceUnit PlaceUnitOf(GridAxes axes);

/// Throws Error where places are in another unit than x and y of their volume. `what` begins the
/// message: the places and their verb, as in "the section is".
void CheckPlaceUnit(PlaceUnit given, PlaceUnit ofVolume, const std::string& what);

} // namespace nexrad

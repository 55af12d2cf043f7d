// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "nexrad/Grid/GridSpecification.h"
#include "nexrad/Model/Site.h"

#include <array>
#include <cstddef>
#include <optional>
#include <vector>

namespace nexrad
{

/// A sample as the thesis places it: m east and north of the site on its flat map, and m above mean
/// sea level.
struct ThesisPoint
{
  double east = 0.0;
  double north = 0.0;
  double altitude = 0.0;
};

/// Direction of a ray with its sines and cosines taken once (Formulas T1, T2). The beam is straight
/// and the earth a sphere of 6 367 450 m: at 0.5° and 230 km, 1 km above where refraction puts it.
class ThesisRay
{
public:
  /// Angles in degrees, the site's altitude in m above mean sea level.
  ThesisRay(double azimuth, double elevation, double siteAltitude);

  /// The sample at `slantRange` m.
  ThesisPoint Locate(double slantRange) const;

private:
  double cosElevation;
  double sinElevation;
  double eastPart;
  double northPart;
  double radiusAtSite; // m
};

/// Longitude and latitude in degrees of a point of the site's flat map (Formulas T1).
std::array<double, 2> ThesisGeographic(const Position& site, double east, double north);

/// Finds the cells of a grid that the thesis's samples of one site fall into (Formulas T3). On
/// projected axes the map from longitude and latitude to x and y is taken exactly on a lattice of
/// 5 km about the site and linearly between: within 5 m below 70° of latitude.
class ThesisCells
{
public:
  /// `radius` in m: samples farther east, west, north or south of the site belong to no cell. At
  /// most LargestRadius is looked at. Only the cells of `block` are found; the default is all.
  ThesisCells(const GridSpecification& grid, const Position& site, double radius,
    const std::optional<VoxelBlock>& block = {});

  static constexpr double LargestRadius = 600'000.0; ///< m, beyond the range of every radar

  /// Index among the block's voxels of the one that holds the sample, or −1 outside of it. On a
  /// face between two cells it is the upper one.
  std::ptrdiff_t Find(const ThesisPoint& point) const;

  /// Horizontal place in cells from the grid's lower faces: 0.5 is the middle of the first cell.
  /// NaN outside the radius.
  std::array<double, 2> CellCoordinates(double east, double north) const;

private:
  VoxelBlock block;
  double bottom;     // m, lower face
  double cellHeight; // m
  double reach;      // m, the lattice covers −reach…reach
  double nodesPerMetre;
  std::size_t nodes;                          // along one side
  std::vector<std::array<double, 2>> lattice; // cell coordinates at the nodes, east fastest
};

/// Whether samples of a site within `radius` m may fall into a block. Errs to one side: without, no
/// sample does.
bool ThesisMayReach(
  const GridSpecification& grid, const VoxelBlock& block, const Position& site, double radius);

} // namespace nexrad

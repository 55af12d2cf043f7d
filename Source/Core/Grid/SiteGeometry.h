// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "nexrad/Geometry/Beam.h"
#include "nexrad/Grid/GridSpecification.h"
#include "nexrad/Model/Site.h"
#include "nexrad/System/RangeLoop.h"

#include <array>
#include <cstddef>
#include <limits>
#include <optional>
#include <vector>

namespace nexrad
{

/// A column of voxels as one radar sees it, in the terms that the merge computes with.
struct ColumnDirection
{
  float azimuth = 0.0F;     ///< degrees clockwise from north, 0 ≤ azimuth < 360
  float halfTangent = 0.0F; ///< tan(γ/2), γ = s/a_e the arc along the ground (Formulas B2)
};

/// The columns of a grid as seen from one radar (Formulas B3, G7): worked out once a run. Geodesics
/// are computed on a lattice of about 10 km and interpolated between; the horizontal error is below
/// 5 m for latitudes to 70°.
class SiteGeometry
{
public:
  /// No radar of the network has gates beyond, m. Columns that lie farther have the azimuth 0.
  static constexpr double FarthestGate = 480'000.0;

  /// Only the columns within `reach` m of the site along the ground are kept (and some beyond, for
  /// what is kept is a box of columns), and of them only those of `block`; they are the same for
  /// any block.
  SiteGeometry(const GridSpecification& grid, const Position& site, double reach,
    const BeamModel& beam = BeamModel(), const std::optional<VoxelBlock>& block = {});

  /// The columns of a grid within a box round the circle of `reach` m about a site.
  static VoxelBlock ColumnsAbout(const GridSpecification& grid, const Position& site, double reach);

  /// The box of columns kept: begin ≤ x < end, likewise y. Empty boxes have begin = end.
  int BeginX() const { return box.begin[0]; }
  int EndX() const { return box.end[0]; }
  int BeginY() const { return box.begin[1]; }
  int EndY() const { return box.end[1]; }

  /// The columns BeginX() to EndX() − 1 of a row in the box.
  const ColumnDirection* Row(int y) const
  {
    return columns.data() + static_cast<std::size_t>(y - box.begin[1]) * this->Width();
  }

  /// The smallest halfTangent of the columns kept; infinity without any.
  float Nearest() const { return nearest; }

  std::size_t MemoryBytes() const { return columns.size() * sizeof(ColumnDirection); }
  /// The most that MemoryBytes can be for a block of so many rows of the grid; 0 for all rows.
  static std::size_t MemoryBytesOf(
    const GridSpecification& grid, const Position& site, double reach, int rows = 0);
  /// The most that it can be for a grid of these dimensions, wherever the radar stands.
  static std::size_t MostMemoryBytes(const std::array<int, 3>& dimensions);

private:
  std::size_t Width() const { return static_cast<std::size_t>(box.Size(0)); }

  VoxelBlock box; // along x and y alone
  float nearest = std::numeric_limits<float>::infinity();
  std::vector<ColumnDirection> columns; // x fastest
};

/// The voxels of a grid as one radar sees them: where the beam points that passes through a voxel's
/// centre, and how far away the voxel is. Each array has a value for every voxel, x fastest, then
/// y, then z upward.
struct RadarView
{
  std::vector<float> azimuth;    ///< degrees clockwise from north, 0 ≤ azimuth < 360
  std::vector<float> elevation;  ///< degrees above the horizon at the antenna
  std::vector<float> slantRange; ///< m along the beam
};

/// Calls `visit(name, values)` for each array: "azimuth", "elevation" and "slant_range", as images
/// and files name them.
template <class View, class Visit>
void ForEachArray(View& view, const Visit& visit)
{
  visit("azimuth", view.azimuth);
  visit("elevation", view.elevation);
  visit("slant_range", view.slantRange);
}

/// The view of a radar: azimuth and ground distance by the geodesic from its site (Formulas B3),
/// elevation and slant range by the inverse of the beam's path over an earth of 4/3 of its radius
/// (Formulas B2). `loop` runs rows.
RadarView MakeRadarView(
  const GridSpecification& grid, const Position& radar, const RangeLoop& loop = {});

} // namespace nexrad

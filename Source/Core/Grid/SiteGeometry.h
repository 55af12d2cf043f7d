// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "nexrad/Geometry/Beam.h"
#include "nexrad/Grid/GridSpecification.h"
#include "nexrad/Grid/VoxelBlock.h"
#include "nexrad/Model/Site.h"

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
  /// Only the columns within `reach` m of the site along the ground are kept (and some beyond, for
  /// what is kept is a box of columns), and of them only those of `block`; they are the same for
  /// any block.
  SiteGeometry(const GridSpecification& grid, const Position& site, double reach,
    const BeamModel& beam = BeamModel(), const std::optional<VoxelBlock>& block = {});

  /// The box of columns kept: begin ≤ x < end, likewise y. Empty boxes have begin = end.
  int BeginX() const { return begin[0]; }
  int EndX() const { return end[0]; }
  int BeginY() const { return begin[1]; }
  int EndY() const { return end[1]; }

  /// The columns BeginX() to EndX() − 1 of a row in the box.
  const ColumnDirection* Row(int y) const
  {
    return columns.data() + static_cast<std::size_t>(y - begin[1]) * this->Width();
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
  std::size_t Width() const { return static_cast<std::size_t>(end[0] - begin[0]); }

  int begin[2] = {0, 0};
  int end[2] = {0, 0};
  float nearest = std::numeric_limits<float>::infinity();
  std::vector<ColumnDirection> columns; // x fastest
};

} // namespace nexrad

// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "nexrad/Polar/GateCode.h"

#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

namespace nexrad
{

struct BeamSweep;

/// A sweep reduced to the resolution of a grid whose voxels are coarser than its gates: means over
/// cells of about equal area (Formulas G10). Rings of one width along the range; a ring is divided
/// into sectors where voxels are coarser than the rays' spacing too, and into the rays of the sweep
/// elsewhere. Interpolated bilinearly, the cells smooth as much as a mean over the voxel.
struct SweepMeans
{
  /// The mean over one cell: the value of the number (GateScale) over its echo, which fills
  /// echo/255 of it; missing/255 of it was not measured, and the rest is no echo. A cell of which
  /// nothing was measured has, in place of the number, the code of the state that most of it has.
  struct Cell
  {
    std::uint16_t code = 0; ///< the number, or the code of a state
    std::uint8_t echo = 0;
    std::uint8_t missing = 0;

    /// All of it in one number, which is 0 for a cell of no echo alone.
    std::uint32_t Word() const
    {
      return code | static_cast<std::uint32_t>(echo) << 16U |
             static_cast<std::uint32_t>(missing) << 24U;
    }
  };

  struct Ring
  {
    std::uint32_t first = 0; ///< place of its first cell
    int sectors = 0;         ///< 0: its cells are the entries of the sweep
    float sectorsPerDegree = 0.0F;
  };

  float reach = -std::numeric_limits<float>::infinity(); ///< m, slant range below which the means
                                                         ///< serve, and from which gates do
  float firstRing = 0.0F;     ///< m, slant range of the first ring's middle
  float ringsPerMetre = 0.0F; ///< 1 / width of the rings
  GateScale scale;            ///< of the numbers; finer than that of the gates
  float spread = 0.0F;     ///< m along the ground: a gate farther from a column, but for its length
                           ///< and its ray's width, does not count in the column's sample
  std::vector<Ring> rings; ///< outwards
  std::vector<Cell> cells; ///< of a ring of n sectors n + 2: the last, all, the first again

  std::size_t MemoryBytes() const
  {
    return rings.size() * sizeof(Ring) + cells.size() * sizeof(Cell);
  }
};

/// Reduces a sweep for voxels that are `side` m wide. Along the range, gates are put together where
/// the side is more than twice their spacing; across it, rays where it is more than twice theirs
/// and more than the gates' spacing. Without either, and for a moment that takes the nearest gate,
/// the means are empty.
SweepMeans MakeSweepMeans(const BeamSweep& sweep, const ValueRule& rule, double side);

} // namespace nexrad

// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "nexrad/Grid/GriddedVolume.h"
#include "nexrad/Polar/PolarVolume.h"
#include "nexrad/System/Progress.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

namespace nexrad
{

/// Fills the gaps of the columns of a grid (Formulas T7): between two known voxels linearly in
/// height, below the lowest known one with its value; above the highest nothing is filled. NaN
/// marks a voxel that is not known.
void FillColumns(std::vector<float>& values, const std::array<int, 3>& dimensions);

/// The volumes of one site about a time, which has a position. One of them may be missing
/// (nullptr): the other is then used unchanged. The volumes are not owned.
struct SiteBracket
{
  const PolarVolume* before = nullptr;
  const PolarVolume* after = nullptr;

  const PolarVolume& Any() const { return before != nullptr ? *before : *after; }
};

/// Bytes a voxel that MergeThesis has beside those of its result: sums, counts and means.
constexpr std::size_t ThesisBytesAVoxel = sizeof(double) + sizeof(std::uint32_t) + sizeof(float);

/// Merges the sites as the thesis does (Formulas T1–T7): each gate interpolated in time between the
/// two volumes (T4), limited to 0…80 dBZ (T5), dropped into its cell (T1–T3), averaged (T6), gaps
/// of each column filled (T7). Volume files carry whole dBZ (T8). Fill value 0; what no sample
/// reached after the fill is NotScanned, a value of 0 is NoEcho, the rest is Echo. Empty when
/// `progress` asked to stop. With a block, that part of the grid is made, as it is in the whole; of
/// a site that ThesisMayReach does not find there, volumes without sweeps do as well. Throws Error
/// for a grid without voxels, and as PartOf does.
std::optional<GriddedVolume> MergeThesis(const std::vector<SiteBracket>& sites,
  const GridSpecification& grid, Time time, const Progress& progress = {},
  const std::optional<VoxelBlock>& block = {});

} // namespace nexrad

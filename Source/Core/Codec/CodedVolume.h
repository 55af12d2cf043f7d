// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "nexrad/Grid/GriddedVolume.h"
#include "nexrad/System/RangeLoop.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>

namespace nexrad
{

/// What codes of one byte stand for.
struct VoxelCodes
{
  static constexpr std::size_t Count = 256;

  std::array<float, Count> values{}; ///< moment's unit; the volume's fill where it is no echo
  std::array<VoxelState, Count> states{};
};

/// Sets the values and states of `count` voxels from their codes.
void ExpandCodes(const VoxelCodes& meaning, const std::uint8_t* codes, std::size_t count,
  float* values, VoxelState* states, const RangeLoop& loop = {});

/// One moment of a merged volume as one byte a voxel.
struct CodedVolume
{
  GriddedVolume volume; ///< without values and states
  VoxelCodes meaning;
  std::unique_ptr<std::uint8_t[]> codes; ///< x fastest, then y, then z upward
  /// Some of the voxels that have the code of no echo are range folded or filtered; no code tells
  /// which.
  bool furtherStates = false;
};

} // namespace nexrad

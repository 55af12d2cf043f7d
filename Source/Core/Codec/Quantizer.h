// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "nexrad/Grid/GriddedVolume.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace nexrad
{

/// Codes of 7 bits for the voxels of a volume: 0 no echo, 127 not scanned, else an echo of
/// offset + scale × code. An echo whose code would be 0 or less is no echo; one above `maximum` is
/// stored as `maximum`, or as code 126 where that is less. The default is the whole dBZ from 1 to
/// 80. Range folded has no code of its own and becomes 0.
struct Quantizer
{
  static constexpr std::uint8_t NoEchoCode = 0;
  static constexpr std::uint8_t LargestCode = 126;
  static constexpr std::uint8_t NotScannedCode = 127;

  double offset = 0.0;   ///< unit of the moment
  double scale = 1.0;    ///< unit of the moment a code, above 0
  double maximum = 80.0; ///< unit of the moment

  /// The code of a voxel. A value that is not a number counts as not scanned.
  std::uint8_t Encode(float value, VoxelState state) const;
  /// The state that a code stands for.
  static VoxelState StateOf(std::uint8_t code);
  /// The value of an echo's code.
  float ValueOf(std::uint8_t code) const { return static_cast<float>(offset + scale * code); }

  /// Codes of all voxels. Throws Error when offset, scale or maximum cannot be used, or when the
  /// volume has not as many values and states as voxels.
  std::vector<std::uint8_t> EncodeAll(const GriddedVolume& volume) const;
  /// Throws as EncodeAll does.
  void Check(const GriddedVolume& volume) const;
  /// Codes of the voxels [begin, end) of a volume that Check let pass.
  void EncodeSome(
    const GriddedVolume& volume, std::size_t begin, std::size_t end, std::uint8_t* codes) const;
  /// Sets values and states of a volume from codes; voxels without echo get the volume's fill.
  void DecodeAll(const std::vector<std::uint8_t>& codes, GriddedVolume& volume) const;
};

/// Throws Error unless the volume has one value and one state for each voxel of its grid.
void CheckVoxelCount(const GriddedVolume& volume);

} // namespace nexrad

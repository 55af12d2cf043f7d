// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "nexrad/Codec/NxvBrick.h"
#include "nexrad/Codec/NxvHeader.h"
#include "nexrad/Codec/NxvLevels.h"
#include "nexrad/Compression/Deflate.h"
#include "nexrad/Grid/GriddedVolume.h"

#include <cstddef>
#include <filesystem>
#include <vector>

namespace nexrad
{

/// An array of a volume in bricks, or of one of its levels.
struct NxvPackedArray
{
  NxvArray array; ///< without lengths and check sum
  DeflateSearch search = DeflateSearch::Repeats;
  std::vector<NxvBrick> bricks; ///< in the order of a file

  /// Of a grid, left out of it as yet.
  NxvPackedArray(const NxvArray& theArray, DeflateSearch theSearch, std::size_t count);
};

/// A volume in bricks, or one of its levels.
struct NxvPackedLevel
{
  GridSpecification grid;
  VoxelsInOne voxels = {1, 1, 1}; ///< of the volume, in one of its
  /// All that bands can have (AddBandArrays), in the order in which one band has them.
  std::vector<NxvPackedArray> arrays;
};

/// A volume file that NxvBandWriter writes, in memory as it is packed.
struct NxvPackedVolume
{
  bool exact = false;                 ///< NxvEncoding::Float
  std::vector<NxvPackedLevel> levels; ///< from fine to coarse; the first is the volume itself

  /// Throws Error, naming the file, for one that is damaged, or that NxvBandWriter does not write.
  static NxvPackedVolume Read(const std::filesystem::path& path);

  /// Writes the file as NxvBandWriter does. `description` says what the volume is, but for its
  /// grid. Throws Error when it cannot be written.
  void Write(const std::filesystem::path& path, const GriddedVolume& description) const;

  std::size_t MemoryBytes() const;
};

} // namespace nexrad

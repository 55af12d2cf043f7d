// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "nexrad/Grid/GriddedVolume.h"

#include <cstddef>
#include <cstdint>
#include <list>
#include <optional>
#include <vector>

namespace nexrad
{

/// Merged volumes, kept up to a limit of memory for the times that are asked for again. They are
/// packed without loss: a run of equal values takes eight bytes, so that a volume takes little more
/// than its echo.
class VolumeCache
{
public:
  /// `limit` in bytes; 0 keeps nothing.
  explicit VolumeCache(std::size_t theLimit)
    : limit(theLimit)
  {
  }

  /// Keeps the volume of a block; those that were not asked for longest make room for it. A volume
  /// that is larger than the limit is not kept.
  void Keep(const VoxelBlock& block, const GriddedVolume& volume);

  /// The volume of a block at a time, bit by bit as it was kept; empty when it is not kept.
  std::optional<GriddedVolume> Find(const VoxelBlock& block, Time time);

  void Clear();

  /// Bytes that the volumes take, at most the limit.
  std::size_t Used() const { return used; }

private:
  struct Packed
  {
    VoxelBlock block;
    GriddedVolume description; ///< the volume without its arrays
    std::vector<std::uint8_t> arrays;
  };

  std::list<Packed>::iterator Place(const VoxelBlock& block, Time time);

  const std::size_t limit;
  std::list<Packed> entries; // the one asked for last stands first
  std::size_t used = 0;
};

} // namespace nexrad

// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "nexrad/Grid/GriddedVolume.h"
#include "nexrad/Grid/VoxelBlock.h"
#include "nexrad/Merging/KeptValues.h"

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <utility>
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
    , entries(theLimit)
  {
  }

  /// Keeps the volume of a block; those that were not asked for longest make room for it. A volume
  /// that is larger than the limit is not kept.
  void Keep(const VoxelBlock& block, const GriddedVolume& volume);

  /// The volume of a block at a time, bit by bit as it was kept; empty when it is not kept.
  std::optional<GriddedVolume> Find(const VoxelBlock& block, Time time);

  void Clear() { entries.Clear(); }

  /// Bytes that the volumes take, at most the limit.
  std::size_t Used() const { return entries.Used(); }

private:
  struct Packed
  {
    GriddedVolume description; ///< the volume without its arrays
    std::vector<std::uint8_t> arrays;
  };

  const std::size_t limit;
  KeptValues<std::pair<Time, VoxelBlock>, std::shared_ptr<const Packed>> entries;
};

} // namespace nexrad

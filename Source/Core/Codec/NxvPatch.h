// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "nexrad/Grid/GridSpecification.h"
#include "nexrad/Grid/GriddedVolume.h"
#include "nexrad/System/RangeLoop.h"

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <vector>

namespace nexrad
{

/// A volume file in bricks of which parts are replaced. It is kept in memory as it is packed, and
/// only the bricks that change are packed again, in the volume and in its coarser levels. What is
/// written is what NxvBandWriter writes of the whole changed volume, byte for byte.
class NxvPatcher
{
public:
  /// Reads a file that NxvBandWriter wrote, of codes or exact. Throws Error, naming the file, for
  /// one that is damaged, or not in such bricks and levels.
  explicit NxvPatcher(const std::filesystem::path& path);
  ~NxvPatcher();
  NxvPatcher(const NxvPatcher&) = delete;
  NxvPatcher& operator=(const NxvPatcher&) = delete;

  const GridSpecification& Grid() const;
  /// Columns along x and y of what must be replaced as a whole: a voxel of the coarsest level; 1
  /// without levels.
  int CellSize() const;
  /// Columns along x and y of a tile: those of a brick, or of a cell if that is larger.
  int TileSize() const;

  /// Replaces voxels of so many tiles, which do not overlap. Along x and y the block of each, of
  /// one tile or several, goes from multiples of TileSize to such multiples or to the end of the
  /// grid; its cells have CellSize columns. Calls make(i) for each i < count, several at a time by
  /// `loop`; nothing: that tile does not change. Throws Error for a tile that does not fit, and
  /// what `make` throws; then no voxel has been replaced.
  void Replace(std::size_t count,
    const std::function<std::optional<ChangedTile>(std::size_t number)>& make,
    const RangeLoop& loop = {});

  /// Writes the volume as NxvBandWriter does. `description` says what it is, but for the grid.
  /// Throws Error when it cannot be written; nothing half-written stays.
  void Write(const std::filesystem::path& path, const GriddedVolume& description) const;

  /// Bytes that the packed volume takes.
  std::size_t MemoryBytes() const;

private:
  struct Impl;
  std::unique_ptr<Impl> impl;
};

} // namespace nexrad

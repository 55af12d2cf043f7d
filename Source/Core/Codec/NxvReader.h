// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "nexrad/Grid/GriddedVolume.h"
#include "nexrad/Grid/MomentCode.h"
#include "nexrad/System/RangeLoop.h"

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace nexrad
{

struct NxvReadOptions
{
  std::size_t maximumBytes = std::size_t(4) << 30; ///< what the voxels may take in memory, with
                                                   ///< what the caller makes of them
  std::size_t bytesBesides = 0; ///< that the caller makes of each voxel of a moment, as of an image
                                ///< or picture
  std::vector<std::string> leaveOut = {}; ///< names of ancillary arrays not to read
  RangeLoop loop = {}; ///< unpacks parts of the arrays; empty: on the calling thread
  /// Moments to read; the first of them is that of the volume, the others are its further ones.
  /// Empty: all, in the order of the file.
  std::vector<MomentName> moments = {};
  /// The part of the grid to read, whose grid the volume then has; of a file in bricks, the others
  /// are not read. Empty: all of it.
  std::optional<VoxelBlock> block = {};
  /// Which of ReadNxvLevels is read; `block` is one of its grid. Coarser levels have no ancillary
  /// arrays.
  std::size_t level = 0;
};

/// Reads one volume. Throws Error naming the file and the byte offset for a wrong magic, header,
/// dimension, length, CRC or stream, for an ancillary array of a wrong type or with a value that it
/// cannot have, for a moment or level to read that the file does not have, and for a block outside
/// the grid. Arrays beside the moments, their states and their ancillary arrays are checked and
/// passed over.
GriddedVolume ReadNxv(const std::filesystem::path& path, const NxvReadOptions& options = {});

/// One moment of a merged volume as one byte a voxel.
struct CodedVolume
{
  GriddedVolume volume; ///< without values and states
  VoxelCodes meaning;
  std::unique_ptr<std::uint8_t[]> codes; ///< x fastest, then y, then z upward
};

/// Reads one moment as the codes that the file has, and its ancillary arrays. Nothing when several
/// moments are to be read, or the file has no codes of one byte of it, but codes of two or floats;
/// with `allStates`, also when voxels are range folded or filtered, which no code tells from no
/// echo. Throws Error as ReadNxv does.
std::optional<CodedVolume> ReadNxvCodes(
  const std::filesystem::path& path, const NxvReadOptions& options = {}, bool allStates = false);

/// Whether ReadNxvCodes would give something, of all states or not.
bool HasNxvCodes(const std::filesystem::path& path, const NxvReadOptions& options = {});

/// Voxels that take memory in the pages of a picture: of a file in bricks those of the bricks that
/// have some of the wanted block and of which not all are equal, in the first wanted moment; of
/// others all of the block.
std::size_t CountVoxelsThatDiffer(
  const std::filesystem::path& path, const NxvReadOptions& options = {});

/// Reads the header alone: the same volume without values, states and ancillary arrays.
GriddedVolume ReadNxvHeader(const std::filesystem::path& path);

/// The grids in which the file has the volume, from fine to coarse; the first is its own.
std::vector<GridSpecification> ReadNxvLevels(const std::filesystem::path& path);

/// Whether the file has its first moment in bricks.
bool IsNxvInBricks(const std::filesystem::path& path);

/// The moments in the file, in its order.
std::vector<MomentName> ReadNxvMoments(const std::filesystem::path& path);

/// Names of the ancillary arrays of all moments in the file, as `REF_age`, in the order of the
/// file.
std::vector<std::string> ReadNxvAncillaryArrayNames(const std::filesystem::path& path);

} // namespace nexrad

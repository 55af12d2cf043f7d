// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "nexrad/Codec/NxvHeader.h"
#include "nexrad/Compression/Deflate.h"
#include "nexrad/Grid/GridSpecification.h"
#include "nexrad/System/RangeLoop.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

namespace nexrad
{

/// Voxels along x, y and z of the bricks that are written; at the upper faces of a grid they have
/// fewer.
constexpr std::array<int, 3> NxvBrickSize = {64, 64, 8};

/// What the `<NAME>_state` array of a volume in bricks has where the code tells the state.
constexpr std::uint8_t NxvStateAsCode = 255;

/// How the bytes of an array lie when it is unpacked: a byte or more of each voxel, or the lower
/// bytes of all voxels and then the higher bytes of all.
struct NxvVoxelBytes
{
  std::size_t planes = 1; ///< times all voxels
  std::size_t bytes = 1;  ///< of a voxel in a plane

  static NxvVoxelBytes Of(NxvType type);
};

/// Copies the voxels that two blocks of a grid have in common, from the array of the first to that
/// of the second.
void CopyCommon(const NxvVoxelBytes& each, const VoxelBlock& from, const std::uint8_t* bytes,
  const VoxelBlock& block, std::uint8_t* target);

/// What follows the header of a file: one part after the other.
using NxvPayload = std::vector<const std::vector<std::uint8_t>*>;

/// Reads `size` bytes of an array's payload from `offset`.
using PayloadReader =
  std::function<std::vector<std::uint8_t>(std::uint64_t offset, std::size_t size)>;

/// The arrays of a volume whose bricks are made band after band: rows of the grid, as many as a
/// brick has, or fewer at the end.
class NxvBrickArrays
{
public:
  explicit NxvBrickArrays(const GridSpecification& grid);

  /// So many rows that follow the last ones made, as far as the grid has them; by default those of
  /// the next band.
  VoxelBlock NextRows(int rows = NxvBrickSize[1]) const;
  /// Begins those rows, and returns them. Throws Error after the last ones.
  const VoxelBlock& BeginBand(int rows = NxvBrickSize[1]);
  /// Adds an array of the band, of which `source` gives the bytes as NxvVoxelBytes has them; `loop`
  /// makes its bricks. What is said of the array must be the same in all bands.
  void Add(
    const NxvArray& array, DeflateSearch search, const ByteSource& source, const RangeLoop& loop);
  /// Ends the band. In arrays that it did not have, but another band has, all its voxels are
  /// NxvStateAsCode in an array of states, and else 0.
  void EndBand();

  /// Adds the next rows, whole bands, whose bricks were finished by themselves: `finished` has
  /// their arrays, whose payloads `read` reads one after the other. Throws Error for an index that
  /// does not fit.
  void AddRows(int rows, const std::vector<NxvArray>& finished, const PayloadReader& read);

  /// The arrays, with lengths and check sums; after the last band. Adds their payloads, of two
  /// parts each, which live as long as this.
  std::vector<NxvArray> Finish(NxvPayload& payload);

private:
  struct Brick
  {
    std::vector<std::uint8_t> stream; // empty: all voxels have `value`
    std::uint32_t value = 0;
  };
  struct Growing
  {
    NxvArray array;
    std::vector<std::uint8_t> index; // 8 bytes a brick until it is finished
    std::vector<std::uint8_t> bricks;
  };

  std::size_t BricksInBand() const;
  VoxelBlock BrickInBand(std::size_t number) const;
  Growing& Find(const NxvArray& array);
  static void Append(const Brick& brick, Growing& to);
  static void FillUp(std::size_t count, Growing& to);

  const std::array<int, 3> dimensions;
  VoxelBlock band;              // of the grid
  std::size_t bricksBefore = 0; // the band
  std::vector<Growing> arrays;
};

/// Unpacks the voxels of a block of an array in bricks into `target`; bricks elsewhere are not
/// read. Throws Error for an index or a brick that is damaged or does not fit the grid.
void ReadBricks(const NxvArray& array, const std::array<int, 3>& dimensions,
  const VoxelBlock& block, const PayloadReader& read, std::uint8_t* target, const RangeLoop& loop);

/// Voxels of the bricks that have voxels of a block, and of which not all are equal. Throws Error
/// as ReadBricks does for an index.
std::size_t CountVoxelsThatDiffer(const NxvArray& array, const std::array<int, 3>& dimensions,
  const VoxelBlock& block, const PayloadReader& read);

/// Bytes of the index of an array in bricks when it is unpacked.
std::size_t NxvIndexBytes(const NxvArray& array, const std::array<int, 3>& dimensions);

} // namespace nexrad

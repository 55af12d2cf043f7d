// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "nexrad/Codec/NxvBrick.h"
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

/// What the `<NAME>_state` array of a volume in bricks has where the code tells the state.
constexpr std::uint8_t NxvStateAsCode = 255;

/// What follows the header of a file: one part after the other.
using NxvPayload = std::vector<const std::vector<std::uint8_t>*>;

/// Reads `size` bytes of an array's payload from `offset`.
using PayloadReader =
  std::function<std::vector<std::uint8_t>(std::uint64_t offset, std::size_t size)>;

/// Whether a volume has the array only where some voxel needs it: one of states, or that of the
/// filtered voxels.
bool NxvMayBeLeftOut(const NxvArray& array);

/// What an array has where it was left out: NxvStateAsCode in one of states, else 0.
std::uint32_t NxvLeftOutValue(const NxvArray& array);

/// The payload of an array in bricks, which grows in their order.
struct NxvBrickPayload
{
  NxvArray array;
  std::vector<std::uint8_t> index; ///< 8 bytes a brick until it is finished
  std::vector<std::uint8_t> bricks;

  void Append(const NxvBrick& brick);
  /// Adds bricks of NxvLeftOutValue, up to so many in all.
  void FillUp(std::size_t count);
  /// The array, with its lengths and check sum; after the last brick. Adds the payload, of two
  /// parts, which live as long as this.
  NxvArray Finish(NxvPayload& payload);
};

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
  /// Ends the band. In arrays that it did not have, but another band has, all its voxels have
  /// NxvLeftOutValue.
  void EndBand();

  /// Adds the next rows, whole bands, whose bricks were finished by themselves: `finished` has
  /// their arrays, whose payloads `read` reads one after the other. Throws Error for an index that
  /// does not fit.
  void AddRows(int rows, const std::vector<NxvArray>& finished, const PayloadReader& read);

  /// The arrays, with lengths and check sums; after the last band. Adds their payloads, of two
  /// parts each, which live as long as this.
  std::vector<NxvArray> Finish(NxvPayload& payload);

private:
  std::size_t BricksInBand() const;
  VoxelBlock BrickInBand(std::size_t number) const;
  NxvBrickPayload& Find(const NxvArray& array);

  const std::array<int, 3> dimensions;
  VoxelBlock band;              // of the grid
  std::size_t bricksBefore = 0; // the band
  std::vector<NxvBrickPayload> arrays;
};

/// Unpacks the voxels of a block of an array in bricks into `target`; bricks elsewhere are not
/// read. Throws Error for an index or a brick that is damaged or does not fit the grid.
void ReadBricks(const NxvArray& array, const std::array<int, 3>& dimensions,
  const VoxelBlock& block, const PayloadReader& read, std::uint8_t* target, const RangeLoop& loop);

/// All bricks of an array as the file has them, in its order. Throws Error as ReadBricks does for
/// an index.
std::vector<NxvBrick> ReadPackedBricks(
  const NxvArray& array, const std::array<int, 3>& dimensions, const PayloadReader& read);

/// Voxels of the bricks that have voxels of a block, and of which not all are equal. Throws Error
/// as ReadBricks does for an index.
std::size_t CountVoxelsThatDiffer(const NxvArray& array, const std::array<int, 3>& dimensions,
  const VoxelBlock& block, const PayloadReader& read);

/// Bytes of the index of an array in bricks when it is unpacked.
std::size_t NxvIndexBytes(const NxvArray& array, const std::array<int, 3>& dimensions);

} // namespace nexrad

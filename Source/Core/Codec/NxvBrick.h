// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "nexrad/Codec/NxvHeader.h"
#include "nexrad/Compression/Deflate.h"
#include "nexrad/Grid/GridSpecification.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace nexrad
{

/// Voxels along x, y and z of the bricks that are written; at the upper faces of a grid they have
/// fewer.
constexpr std::array<int, 3> NxvBrickSize = {64, 64, 8};

/// How the bytes of an array lie when it is unpacked: a byte or more of each voxel, or the lower
/// bytes of all voxels and then the higher bytes of all.
struct NxvVoxelBytes
{
  std::size_t planes = 1; ///< times all voxels
  std::size_t bytes = 1;  ///< of a voxel in a plane

  static NxvVoxelBytes Of(NxvType type);

  /// Bytes of so many voxels.
  std::size_t Count(std::size_t voxels) const { return voxels * planes * bytes; }
};

/// Bricks along x, y and z of a grid.
std::array<int, 3> BricksAlong(
  const std::array<int, 3>& dimensions, const std::array<int, 3>& size);
std::size_t CountBricks(const std::array<int, 3>& dimensions, const std::array<int, 3>& size);

/// The voxels of a brick, by its place among the bricks of a grid.
VoxelBlock BrickAt(const std::array<int, 3>& place, const std::array<int, 3>& dimensions,
  const std::array<int, 3>& size);

/// Voxels of a block along x, y and z.
std::array<int, 3> SizeOf(const VoxelBlock& block);

/// The voxels that two blocks of a grid have in common, if any.
VoxelBlock CommonVoxels(const VoxelBlock& a, const VoxelBlock& b);

/// Copies some voxels, which two blocks of a grid have in common, from the array of the first to
/// that of the second.
void CopyVoxels(const NxvVoxelBytes& each, const VoxelBlock& voxels, const VoxelBlock& from,
  const std::uint8_t* bytes, const VoxelBlock& block, std::uint8_t* target);
/// The same of all voxels that they have in common.
void CopyCommon(const NxvVoxelBytes& each, const VoxelBlock& from, const std::uint8_t* bytes,
  const VoxelBlock& block, std::uint8_t* target);

/// The bytes of a block of a box of voxels, of which `source` gives those of all.
std::vector<std::uint8_t> BytesOfBlock(const NxvVoxelBytes& each, const ByteSource& source,
  const std::array<int, 3>& box, const VoxelBlock& block);

/// The bytes of voxels that are alike; `value` has those of one, the lowest first.
std::vector<std::uint8_t> UniformBytes(
  const NxvVoxelBytes& each, std::uint32_t value, std::size_t voxels);

/// A brick as a file has it.
struct NxvBrick
{
  std::vector<std::uint8_t> stream; ///< of zlib; empty: all voxels have `value`
  std::uint32_t value = 0;          ///< bytes of the first voxel, the lowest first
};

NxvBrick PackBrick(
  const NxvVoxelBytes& each, const std::vector<std::uint8_t>& bytes, DeflateSearch search);

/// The bytes of a brick of so many voxels. Throws Error when it is damaged.
std::vector<std::uint8_t> UnpackBrick(
  const NxvVoxelBytes& each, const NxvBrick& brick, std::size_t voxels);

} // namespace nexrad

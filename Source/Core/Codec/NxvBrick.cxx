// SPDX-License-Identifier: BSD-3-Clause
#include "nexrad/Codec/NxvBrick.h"

#include "nexrad/Codec/LittleEndian.h"

#include <algorithm>
#include <cstring>

namespace nexrad
{

namespace
{

using Bytes = std::vector<std::uint8_t>;

// Calls `visit(row, first, count)` for each row of voxels of a part of a box: `first` is the index
// in the box of the row's first voxel, `row` counts the rows.
template <class Visit>
void ForEachRow(const std::array<int, 3>& box, const VoxelBlock& part, const Visit& visit)
{
  std::size_t row = 0;
  for (int z = part.begin[2]; z < part.end[2]; ++z)
  {
    for (int y = part.begin[1]; y < part.end[1]; ++y)
    {
      const std::size_t before = static_cast<std::size_t>(z) * static_cast<std::size_t>(box[1]) +
                                 static_cast<std::size_t>(y);
      visit(row++,
        before * static_cast<std::size_t>(box[0]) + static_cast<std::size_t>(part.begin[0]),
        static_cast<std::size_t>(part.Size(0)));
    }
  }
}

std::size_t VoxelsOf(const std::array<int, 3>& box)
{
  return static_cast<std::size_t>(box[0]) * static_cast<std::size_t>(box[1]) *
         static_cast<std::size_t>(box[2]);
}

VoxelBlock Within(const VoxelBlock& block, const VoxelBlock& outer)
{
  VoxelBlock relative;
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    relative.begin[axis] = block.begin[axis] - outer.begin[axis];
    relative.end[axis] = block.end[axis] - outer.begin[axis];
  }
  return relative;
}

bool IsUniform(const NxvVoxelBytes& each, const Bytes& bytes)
{
  const std::size_t size = bytes.size() / each.planes;
  for (std::size_t plane = 0; plane < each.planes; ++plane)
  {
    const std::uint8_t* first = bytes.data() + plane * size;
    if (std::memcmp(first, first + each.bytes, size - each.bytes) != 0)
    {
      return false;
    }
  }
  return true;
}

// The bytes of the first voxel, the lowest first.
std::uint32_t FirstValue(const NxvVoxelBytes& each, const Bytes& bytes)
{
  std::array<std::uint8_t, 4> value{};
  for (std::size_t plane = 0; plane < each.planes; ++plane)
  {
    std::copy_n(bytes.data() + plane * (bytes.size() / each.planes), each.bytes,
      value.begin() + static_cast<std::ptrdiff_t>(plane * each.bytes));
  }
  return LittleEndian(value.data());
}

} // namespace

NxvVoxelBytes NxvVoxelBytes::Of(NxvType type)
{
  switch (type)
  {
  case NxvType::UInt16:
    return {2, 1};
  case NxvType::Float32:
    return {1, sizeof(float)};
  default:
    return {1, 1};
  }
}

std::array<int, 3> BricksAlong(const std::array<int, 3>& dimensions, const std::array<int, 3>& size)
{
  std::array<int, 3> along{};
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    along[axis] = (dimensions[axis] - 1) / size[axis] + 1;
  }
  return along;
}

VoxelBlock BrickAt(const std::array<int, 3>& place, const std::array<int, 3>& dimensions,
  const std::array<int, 3>& size)
{
  VoxelBlock brick;
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    brick.begin[axis] = place[axis] * size[axis];
    brick.end[axis] = std::min(brick.begin[axis] + size[axis], dimensions[axis]);
  }
  return brick;
}

std::array<int, 3> SizeOf(const VoxelBlock& block)
{
  return {block.Size(0), block.Size(1), block.Size(2)};
}

VoxelBlock CommonVoxels(const VoxelBlock& a, const VoxelBlock& b)
{
  VoxelBlock common;
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    common.begin[axis] = std::max(a.begin[axis], b.begin[axis]);
    common.end[axis] = std::min(a.end[axis], b.end[axis]);
  }
  return common;
}

std::size_t CountBricks(const std::array<int, 3>& dimensions, const std::array<int, 3>& size)
{
  return VoxelsOf(BricksAlong(dimensions, size));
}

void CopyVoxels(const NxvVoxelBytes& each, const VoxelBlock& voxels, const VoxelBlock& from,
  const std::uint8_t* bytes, const VoxelBlock& block, std::uint8_t* target)
{
  const std::size_t all = from.VoxelCount();
  std::vector<std::size_t> rows;
  ForEachRow(SizeOf(from), Within(voxels, from),
    [&rows](std::size_t, std::size_t first, std::size_t) { rows.push_back(first); });
  for (std::size_t plane = 0; plane < each.planes; ++plane)
  {
    ForEachRow(SizeOf(block), Within(voxels, block),
      [&](std::size_t row, std::size_t first, std::size_t count)
      {
        std::memcpy(target + (plane * block.VoxelCount() + first) * each.bytes,
          bytes + (plane * all + rows[row]) * each.bytes, count * each.bytes);
      });
  }
}

void CopyCommon(const NxvVoxelBytes& each, const VoxelBlock& from, const std::uint8_t* bytes,
  const VoxelBlock& block, std::uint8_t* target)
{
  CopyVoxels(each, CommonVoxels(from, block), from, bytes, block, target);
}

std::vector<std::uint8_t> BytesOfBlock(const NxvVoxelBytes& each, const ByteSource& source,
  const std::array<int, 3>& box, const VoxelBlock& block)
{
  Bytes bytes(each.Count(block.VoxelCount()));
  std::uint8_t* to = bytes.data();
  for (std::size_t plane = 0; plane < each.planes; ++plane)
  {
    ForEachRow(box, block,
      [&](std::size_t, std::size_t first, std::size_t count)
      {
        source((plane * VoxelsOf(box) + first) * each.bytes, count * each.bytes, to);
        to += count * each.bytes;
      });
  }
  return bytes;
}

std::vector<std::uint8_t> UniformBytes(
  const NxvVoxelBytes& each, std::uint32_t value, std::size_t voxels)
{
  Bytes bytes(each.Count(voxels));
  const std::size_t size = voxels * each.bytes; // of a plane
  for (std::size_t place = 0; place < each.planes * each.bytes; ++place)
  {
    const auto byte = static_cast<std::uint8_t>(value >> (8 * place));
    std::uint8_t* const plane = bytes.data() + place / each.bytes * size;
    for (std::size_t i = place % each.bytes; i < size; i += each.bytes)
    {
      plane[i] = byte;
    }
  }
  return bytes;
}

NxvBrick PackBrick(
  const NxvVoxelBytes& each, const std::vector<std::uint8_t>& bytes, DeflateSearch search)
{
  NxvBrick brick;
  brick.value = FirstValue(each, bytes);
  if (!IsUniform(each, bytes))
  {
    brick.stream = DeflateBytes(bytes.data(), bytes.size(), search);
  }
  return brick;
}

std::vector<std::uint8_t> UnpackBrick(
  const NxvVoxelBytes& each, const NxvBrick& brick, std::size_t voxels)
{
  if (brick.stream.empty())
  {
    return UniformBytes(each, brick.value, voxels);
  }
  Bytes bytes(each.Count(voxels));
  InflateBytes(brick.stream.data(), brick.stream.size(), bytes.data(), bytes.size());
  return bytes;
}

} // namespace nexrad

// SPDX-License-Identifier: BSD-3-Clause
#include "nexrad/Codec/NxvBricks.h"

#include "nexrad/Codec/MomentCode.h"
#include "nexrad/System/Error.h"

#include <algorithm>
#include <cstring>
#include <string>

namespace nexrad
{

namespace
{

using Bytes = std::vector<std::uint8_t>;

constexpr std::size_t entrySize = 8; // of the index: length and value of a brick

std::array<int, 3> BricksAlong(const std::array<int, 3>& dimensions, const std::array<int, 3>& size)
{
  std::array<int, 3> along{};
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    along[axis] = (dimensions[axis] - 1) / size[axis] + 1;
  }
  return along;
}

// The voxels of a brick, by its place among the bricks.
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

std::array<int, 3> SizeOf(const VoxelBlock& block)
{
  return {block.Size(0), block.Size(1), block.Size(2)};
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

VoxelBlock Common(const VoxelBlock& a, const VoxelBlock& b)
{
  VoxelBlock common;
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    common.begin[axis] = std::max(a.begin[axis], b.begin[axis]);
    common.end[axis] = std::min(a.end[axis], b.end[axis]);
  }
  return common;
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

// The opposite of FirstValue, for all voxels.
void FillUniform(const NxvVoxelBytes& each, std::uint32_t value, Bytes& bytes)
{
  const std::size_t size = bytes.size() / each.planes;
  for (std::size_t i = 0; i < bytes.size(); ++i)
  {
    const std::size_t place = i / size * each.bytes + i % each.bytes;
    bytes[i] = static_cast<std::uint8_t>(value >> (8 * place));
  }
}

bool IsOfStates(const std::string& name)
{
  const std::string ending = "_state";
  return name.size() > ending.size() &&
         name.compare(name.size() - ending.size(), ending.size(), ending) == 0;
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

void CopyCommon(const NxvVoxelBytes& each, const VoxelBlock& from, const std::uint8_t* bytes,
  const VoxelBlock& block, std::uint8_t* target)
{
  const VoxelBlock common = Common(from, block);
  const std::size_t voxels = from.VoxelCount();
  std::vector<std::size_t> rows;
  ForEachRow(SizeOf(from), Within(common, from),
    [&rows](std::size_t, std::size_t first, std::size_t) { rows.push_back(first); });
  for (std::size_t plane = 0; plane < each.planes; ++plane)
  {
    ForEachRow(SizeOf(block), Within(common, block),
      [&](std::size_t row, std::size_t first, std::size_t count)
      {
        std::memcpy(target + (plane * block.VoxelCount() + first) * each.bytes,
          bytes + (plane * voxels + rows[row]) * each.bytes, count * each.bytes);
      });
  }
}

std::size_t NxvIndexBytes(const NxvArray& array, const std::array<int, 3>& dimensions)
{
  return VoxelsOf(BricksAlong(dimensions, array.brick)) * entrySize;
}

namespace
{

Bytes ReadIndex(
  const NxvArray& array, const std::array<int, 3>& dimensions, const PayloadReader& read)
{
  Bytes index(NxvIndexBytes(array, dimensions));
  const Bytes packed = read(0, array.indexLength);
  InflateBytes(packed.data(), packed.size(), index.data(), index.size());
  return index;
}

} // namespace

NxvBrickArrays::NxvBrickArrays(const GridSpecification& grid)
  : dimensions(grid.dimensions)
  , band(VoxelBlock::Of(grid))
{
  band.end[1] = 0;
}

VoxelBlock NxvBrickArrays::NextRows(int rows) const
{
  VoxelBlock next = band;
  next.begin[1] = band.end[1];
  next.end[1] = std::min(next.begin[1] + rows, dimensions[1]);
  return next;
}

const VoxelBlock& NxvBrickArrays::BeginBand(int rows)
{
  if (band.end[1] == dimensions[1])
  {
    throw Error("all rows of the grid have been made");
  }
  bricksBefore += band.end[1] > 0 ? this->BricksInBand() : 0;
  band = this->NextRows(rows);
  return band;
}

std::size_t NxvBrickArrays::BricksInBand() const
{
  return VoxelsOf(BricksAlong(SizeOf(band), NxvBrickSize));
}

// In the voxels of the band. Bricks that lie one above the other follow each other.
VoxelBlock NxvBrickArrays::BrickInBand(std::size_t number) const
{
  const auto layers = static_cast<std::size_t>(BricksAlong(dimensions, NxvBrickSize)[2]);
  const std::array<int, 3> place = {
    static_cast<int>(number / layers), 0, static_cast<int>(number % layers)};
  return BrickAt(place, SizeOf(band), NxvBrickSize);
}

NxvBrickArrays::Growing& NxvBrickArrays::Find(const NxvArray& array)
{
  const auto found = std::find_if(arrays.begin(), arrays.end(),
    [&array](const Growing& each) { return each.array.name == array.name; });
  if (found != arrays.end())
  {
    return *found;
  }
  arrays.push_back({array, {}, {}});
  Growing& added = arrays.back();
  added.array.storage = NxvStorage::Bricks;
  added.array.brick = NxvBrickSize;
  FillUp(bricksBefore, added);
  return added;
}

// Adds bricks that the array did not have, up to so many in all.
void NxvBrickArrays::FillUp(std::size_t count, Growing& to)
{
  const Brick missing{{}, IsOfStates(to.array.name) ? NxvStateAsCode : 0U};
  while (to.index.size() < count * entrySize)
  {
    Append(missing, to);
  }
}

void NxvBrickArrays::Append(const Brick& brick, Growing& to)
{
  AppendLittleEndian(static_cast<std::uint32_t>(brick.stream.size()), to.index);
  AppendLittleEndian(brick.value, to.index);
  to.bricks.insert(to.bricks.end(), brick.stream.begin(), brick.stream.end());
}

void NxvBrickArrays::Add(
  const NxvArray& array, DeflateSearch search, const ByteSource& source, const RangeLoop& loop)
{
  const NxvVoxelBytes each = NxvVoxelBytes::Of(array.type);
  const std::array<int, 3> size = SizeOf(band);
  std::vector<Brick> bricks(this->BricksInBand());
  RunEach(loop, bricks.size(),
    [&](std::size_t number)
    {
      const VoxelBlock block = this->BrickInBand(number);
      Bytes bytes(block.VoxelCount() * each.planes * each.bytes);
      std::uint8_t* to = bytes.data();
      for (std::size_t plane = 0; plane < each.planes; ++plane)
      {
        ForEachRow(size, block,
          [&](std::size_t, std::size_t first, std::size_t count)
          {
            source((plane * VoxelsOf(size) + first) * each.bytes, count * each.bytes, to);
            to += count * each.bytes;
          });
      }
      Brick& brick = bricks[number];
      brick.value = FirstValue(each, bytes);
      if (!IsUniform(each, bytes))
      {
        brick.stream = DeflateBytes(bytes.data(), bytes.size(), search);
      }
    });
  Growing& growing = this->Find(array);
  for (const Brick& brick : bricks)
  {
    Append(brick, growing);
  }
}

void NxvBrickArrays::EndBand()
{
  const std::size_t all = bricksBefore + this->BricksInBand();
  for (Growing& each : arrays)
  {
    FillUp(all, each);
  }
}

void NxvBrickArrays::AddRows(
  int rows, const std::vector<NxvArray>& finished, const PayloadReader& read)
{
  this->BeginBand(rows);
  std::uint64_t offset = 0;
  for (const NxvArray& array : finished)
  {
    const Bytes index = ReadIndex(array, SizeOf(band),
      [&](std::uint64_t from, std::size_t size) { return read(offset + from, size); });
    const Bytes bricks = read(offset + array.indexLength, array.length - array.indexLength);
    Growing& growing = this->Find(array);
    growing.index.insert(growing.index.end(), index.begin(), index.end());
    growing.bricks.insert(growing.bricks.end(), bricks.begin(), bricks.end());
    offset += array.length;
  }
  this->EndBand();
}

std::vector<NxvArray> NxvBrickArrays::Finish(NxvPayload& payload)
{
  std::vector<NxvArray> finished;
  for (Growing& each : arrays)
  {
    each.index = DeflateBytes(each.index.data(), each.index.size());
    each.array.indexLength = each.index.size();
    each.array.length = each.index.size() + each.bricks.size();
    each.array.crc32 =
      Crc32(each.bricks.data(), each.bricks.size(), Crc32(each.index.data(), each.index.size()));
    finished.push_back(each.array);
    payload.push_back(&each.index);
    payload.push_back(&each.bricks);
  }
  return finished;
}

namespace
{

// A brick of a file that a block has voxels of.
struct StoredBrick
{
  VoxelBlock voxels;
  std::uint64_t offset = 0; // in the payload
  std::uint32_t length = 0;
  std::uint32_t value = 0;
};

bool Touches(const VoxelBlock& a, const VoxelBlock& b)
{
  return Common(a, b).VoxelCount() > 0;
}

// Those of a block, in the order of the file.
std::vector<StoredBrick> FindBricks(const NxvArray& array, const std::array<int, 3>& dimensions,
  const VoxelBlock& block, const Bytes& index)
{
  const std::array<int, 3> along = BricksAlong(dimensions, array.brick);
  std::vector<StoredBrick> found;
  StoredBrick brick;
  brick.offset = array.indexLength;
  const std::uint8_t* entry = index.data();
  std::array<int, 3> place{};
  for (place[1] = 0; place[1] < along[1]; ++place[1])
  {
    for (place[0] = 0; place[0] < along[0]; ++place[0])
    {
      for (place[2] = 0; place[2] < along[2]; ++place[2], entry += entrySize)
      {
        brick.voxels = BrickAt(place, dimensions, array.brick);
        brick.length = LittleEndian(entry);
        brick.value = LittleEndian(entry + 4);
        if (brick.length > array.length - brick.offset)
        {
          throw Error("its index has bricks that are longer than its payload");
        }
        if (Touches(brick.voxels, block))
        {
          found.push_back(brick);
        }
        brick.offset += brick.length;
      }
    }
  }
  if (brick.offset != array.length)
  {
    throw Error("its index has " + std::to_string(brick.offset) + " bytes of bricks, its payload " +
                std::to_string(array.length));
  }
  return found;
}

} // namespace

void ReadBricks(const NxvArray& array, const std::array<int, 3>& dimensions,
  const VoxelBlock& block, const PayloadReader& read, std::uint8_t* target, const RangeLoop& loop)
{
  const NxvVoxelBytes each = NxvVoxelBytes::Of(array.type);
  const std::vector<StoredBrick> bricks =
    FindBricks(array, dimensions, block, ReadIndex(array, dimensions, read));
  std::vector<Bytes> streams;
  for (const StoredBrick& brick : bricks)
  {
    streams.push_back(brick.length > 0 ? read(brick.offset, brick.length) : Bytes());
  }
  RunEach(loop, bricks.size(),
    [&](std::size_t number)
    {
      const StoredBrick& brick = bricks[number];
      Bytes bytes(brick.voxels.VoxelCount() * each.planes * each.bytes);
      if (brick.length == 0)
      {
        FillUniform(each, brick.value, bytes);
      }
      else
      {
        InflateBytes(streams[number].data(), streams[number].size(), bytes.data(), bytes.size());
      }
      CopyCommon(each, brick.voxels, bytes.data(), block, target);
    });
}

std::size_t CountVoxelsThatDiffer(const NxvArray& array, const std::array<int, 3>& dimensions,
  const VoxelBlock& block, const PayloadReader& read)
{
  std::size_t voxels = 0;
  for (const StoredBrick& brick :
    FindBricks(array, dimensions, block, ReadIndex(array, dimensions, read)))
  {
    voxels += brick.length > 0 ? brick.voxels.VoxelCount() : 0;
  }
  return voxels;
}

} // namespace nexrad

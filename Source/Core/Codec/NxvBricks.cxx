// SPDX-License-Identifier: BSD-3-Clause
#include "nexrad/Codec/NxvBricks.h"

#include "nexrad/Codec/LittleEndian.h"
#include "nexrad/System/Error.h"

#include <algorithm>
#include <string>

namespace nexrad
{

namespace
{

using Bytes = std::vector<std::uint8_t>;

constexpr std::size_t entrySize = 8; // of the index: length and value of a brick

bool EndsWith(const std::string& name, const std::string& ending)
{
  return name.size() > ending.size() &&
         name.compare(name.size() - ending.size(), ending.size(), ending) == 0;
}

} // namespace

std::size_t NxvIndexBytes(const NxvArray& array, const std::array<int, 3>& dimensions)
{
  return CountBricks(dimensions, array.brick) * entrySize;
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

bool NxvMayBeLeftOut(const NxvArray& array)
{
  return EndsWith(array.name, "_state") || EndsWith(array.name, "_filtered");
}

std::uint32_t NxvLeftOutValue(const NxvArray& array)
{
  return EndsWith(array.name, "_state") ? NxvStateAsCode : 0U;
}

void NxvBrickPayload::Append(const NxvBrick& brick)
{
  AppendLittleEndian(static_cast<std::uint32_t>(brick.stream.size()), index);
  AppendLittleEndian(brick.value, index);
  bricks.insert(bricks.end(), brick.stream.begin(), brick.stream.end());
}

void NxvBrickPayload::FillUp(std::size_t count)
{
  const NxvBrick leftOut{{}, NxvLeftOutValue(array)};
  while (index.size() < count * entrySize)
  {
    this->Append(leftOut);
  }
}

NxvArray NxvBrickPayload::Finish(NxvPayload& payload)
{
  index = DeflateBytes(index.data(), index.size());
  array.indexLength = index.size();
  array.length = index.size() + bricks.size();
  array.crc32 = Crc32(bricks.data(), bricks.size(), Crc32(index.data(), index.size()));
  payload.push_back(&index);
  payload.push_back(&bricks);
  return array;
}

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
  return CountBricks(SizeOf(band), NxvBrickSize);
}

// In the voxels of the band. Bricks that lie one above the other follow each other.
VoxelBlock NxvBrickArrays::BrickInBand(std::size_t number) const
{
  const auto layers = static_cast<std::size_t>(BricksAlong(dimensions, NxvBrickSize)[2]);
  const std::array<int, 3> place = {
    static_cast<int>(number / layers), 0, static_cast<int>(number % layers)};
  return BrickAt(place, SizeOf(band), NxvBrickSize);
}

NxvBrickPayload& NxvBrickArrays::Find(const NxvArray& array)
{
  const auto found = std::find_if(arrays.begin(), arrays.end(),
    [&array](const NxvBrickPayload& each) { return each.array.name == array.name; });
  if (found != arrays.end())
  {
    return *found;
  }
  arrays.push_back({array, {}, {}});
  NxvBrickPayload& added = arrays.back();
  added.array.storage = NxvStorage::Bricks;
  added.array.brick = NxvBrickSize;
  added.FillUp(bricksBefore);
  return added;
}

void NxvBrickArrays::Add(
  const NxvArray& array, DeflateSearch search, const ByteSource& source, const RangeLoop& loop)
{
  const NxvVoxelBytes each = NxvVoxelBytes::Of(array.type);
  std::vector<NxvBrick> bricks(this->BricksInBand());
  RunEach(loop, bricks.size(),
    [&](std::size_t number)
    {
      const Bytes bytes = BytesOfBlock(each, source, SizeOf(band), this->BrickInBand(number));
      bricks[number] = PackBrick(each, bytes, search);
    });
  NxvBrickPayload& payload = this->Find(array);
  for (const NxvBrick& brick : bricks)
  {
    payload.Append(brick);
  }
}

void NxvBrickArrays::EndBand()
{
  const std::size_t all = bricksBefore + this->BricksInBand();
  for (NxvBrickPayload& each : arrays)
  {
    each.FillUp(all);
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
    NxvBrickPayload& payload = this->Find(array);
    payload.index.insert(payload.index.end(), index.begin(), index.end());
    payload.bricks.insert(payload.bricks.end(), bricks.begin(), bricks.end());
    offset += array.length;
  }
  this->EndBand();
}

std::vector<NxvArray> NxvBrickArrays::Finish(NxvPayload& payload)
{
  std::vector<NxvArray> finished;
  for (NxvBrickPayload& each : arrays)
  {
    finished.push_back(each.Finish(payload));
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
  return CommonVoxels(a, b).VoxelCount() > 0;
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

NxvBrick TakeBrick(const StoredBrick& brick, const PayloadReader& read)
{
  return {brick.length > 0 ? read(brick.offset, brick.length) : Bytes(), brick.value};
}

} // namespace

void ReadBricks(const NxvArray& array, const std::array<int, 3>& dimensions,
  const VoxelBlock& block, const PayloadReader& read, std::uint8_t* target, const RangeLoop& loop)
{
  const NxvVoxelBytes each = NxvVoxelBytes::Of(array.type);
  const std::vector<StoredBrick> bricks =
    FindBricks(array, dimensions, block, ReadIndex(array, dimensions, read));
  std::vector<NxvBrick> packed;
  for (const StoredBrick& brick : bricks)
  {
    packed.push_back(TakeBrick(brick, read));
  }
  RunEach(loop, bricks.size(),
    [&](std::size_t number)
    {
      const VoxelBlock& voxels = bricks[number].voxels;
      const Bytes bytes = UnpackBrick(each, packed[number], voxels.VoxelCount());
      CopyCommon(each, voxels, bytes.data(), block, target);
    });
}

std::vector<NxvBrick> ReadPackedBricks(
  const NxvArray& array, const std::array<int, 3>& dimensions, const PayloadReader& read)
{
  const VoxelBlock all{{0, 0, 0}, dimensions};
  std::vector<NxvBrick> packed;
  for (const StoredBrick& brick :
    FindBricks(array, dimensions, all, ReadIndex(array, dimensions, read)))
  {
    packed.push_back(TakeBrick(brick, read));
  }
  return packed;
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

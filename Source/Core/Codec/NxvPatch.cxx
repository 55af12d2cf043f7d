// SPDX-License-Identifier: BSD-3-Clause
#include "nexrad/Codec/NxvPatch.h"

#include "nexrad/Codec/NxvArrays.h"
#include "nexrad/Codec/NxvBrick.h"
#include "nexrad/Codec/NxvBricks.h"
#include "nexrad/Codec/NxvInput.h"
#include "nexrad/Codec/NxvLevels.h"
#include "nexrad/Codec/NxvPackedVolume.h"
#include "nexrad/System/Error.h"

#include <algorithm>
#include <iterator>
#include <map>
#include <set>
#include <string>
#include <tuple>
#include <utility>

namespace nexrad
{

namespace
{

using Bytes = std::vector<std::uint8_t>;

// What a tile has of a level.
struct TilePart
{
  VoxelBlock block;
  std::vector<VoxelBlock> changed; // the voxels of it that are made anew
  std::vector<Bytes> arrays;       // by their numbers in the level; empty: left out
};

// Bricks of a level that lie one above the other, and the parts of tiles that reach into them.
struct BrickColumn
{
  std::size_t level;
  int x; // among the bricks of the level
  int y;
  std::vector<const TilePart*> parts;
};

// A brick that takes the place of another one.
struct NewBrick
{
  std::size_t level;
  std::size_t array;
  std::size_t number;
  NxvBrick brick;
};

// What remains of a tile when its volume is packed: the bricks, and its parts of coarser levels.
struct PackedTile
{
  VoxelBlock block;
  std::vector<NewBrick> bricks;
  std::vector<TilePart> coarser;
};

VoxelBlock CoarserBlock(const VoxelBlock& block, const VoxelsInOne& voxels)
{
  VoxelBlock coarser;
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    coarser.begin[axis] = block.begin[axis] / voxels[axis];
    coarser.end[axis] = (block.end[axis] - 1) / voxels[axis] + 1;
  }
  return coarser;
}

// Calls `visit(x, y)` for the squares of so many columns that a block reaches into.
template <class Visit>
void ForEachSquare(const VoxelBlock& block, int columns, const Visit& visit)
{
  for (int y = block.begin[1] / columns; y <= (block.end[1] - 1) / columns; ++y)
  {
    for (int x = block.begin[0] / columns; x <= (block.end[0] - 1) / columns; ++x)
    {
      visit(x, y);
    }
  }
}

// The cells of a block that are marked, each as a block of its voxels.
std::vector<VoxelBlock> MarkedCells(
  const VoxelBlock& block, int cell, const std::vector<std::uint8_t>& marks)
{
  std::vector<VoxelBlock> marked;
  std::size_t number = 0;
  ForEachSquare(block, cell,
    [&](int x, int y)
    {
      if (marks[number++] != 0)
      {
        const VoxelBlock all{
          {x * cell, y * cell, block.begin[2]}, {(x + 1) * cell, (y + 1) * cell, block.end[2]}};
        marked.push_back(CommonVoxels(all, block));
      }
    });
  return marked;
}

// Takes an array of a tile's volume for that of a level.
void AddToPart(const NxvArray& array, Bytes bytes, const NxvPackedLevel& level, TilePart& part)
{
  const auto found = std::find_if(level.arrays.begin(), level.arrays.end(),
    [&array](const NxvPackedArray& each) { return each.array.name == array.name; });
  const std::size_t size = NxvVoxelBytes::Of(array.type).Count(part.block.VoxelCount());
  if (found == level.arrays.end() || found->array.type != array.type ||
      found->array.fill != array.fill || bytes.size() != size)
  {
    throw Error("the array \"" + array.name + "\" of a tile is not that of the file");
  }
  part.arrays[static_cast<std::size_t>(found - level.arrays.begin())] = std::move(bytes);
}

TilePart PartOfLevel(
  const NxvPackedLevel& level, bool exact, const VoxelBlock& block, const GriddedVolume& volume)
{
  TilePart part;
  part.block = block;
  part.arrays.resize(level.arrays.size());
  const NxvAddArray add =
    [&](const NxvArray& array, std::size_t size, DeflateSearch, const ByteSource& source)
  {
    Bytes bytes(size);
    source(0, size, bytes.data());
    AddToPart(array, std::move(bytes), level, part);
  };
  AddBandArrays(add, volume, exact);
  for (const GriddedVolume& further : volume.further)
  {
    AddBandArrays(add, further, exact);
  }
  for (std::size_t i = 0; i < part.arrays.size(); ++i)
  {
    if (part.arrays[i].empty() && !NxvMayBeLeftOut(level.arrays[i].array))
    {
      throw Error("a tile must have the array \"" + level.arrays[i].array.name + "\" of the file");
    }
  }
  return part;
}

// Replaces those voxels of a brick that a part makes anew.
void Overlay(const NxvVoxelBytes& each, std::uint32_t leftOut, const TilePart& part,
  std::size_t array, const VoxelBlock& brick, Bytes& bytes)
{
  const Bytes& made = part.arrays[array];
  const Bytes uniform =
    made.empty() ? UniformBytes(each, leftOut, part.block.VoxelCount()) : Bytes();
  for (const VoxelBlock& cell : part.changed)
  {
    const VoxelBlock common = CommonVoxels(cell, brick);
    if (common.VoxelCount() > 0)
    {
      CopyVoxels(
        each, common, part.block, made.empty() ? uniform.data() : made.data(), brick, bytes.data());
    }
  }
}

// A brick with the voxels that the parts make anew; nothing if it stays as it is.
std::optional<NxvBrick> Repack(const NxvPackedArray& packed, std::size_t array,
  const NxvBrick& brick, const VoxelBlock& voxels, const std::vector<const TilePart*>& parts)
{
  const std::uint32_t leftOut = NxvLeftOutValue(packed.array);
  const bool leavesOut = std::all_of(parts.begin(), parts.end(),
    [array](const TilePart* part) { return part->arrays[array].empty(); });
  if (leavesOut && brick.stream.empty() && brick.value == leftOut)
  {
    return std::nullopt;
  }
  const NxvVoxelBytes each = NxvVoxelBytes::Of(packed.array.type);
  const Bytes before = UnpackBrick(each, brick, voxels.VoxelCount());
  Bytes bytes = before;
  for (const TilePart* part : parts)
  {
    Overlay(each, leftOut, *part, array, voxels, bytes);
  }
  return bytes == before ? std::nullopt : std::optional(PackBrick(each, bytes, packed.search));
}

} // namespace

struct NxvPatcher::Impl
{
  std::filesystem::path path;
  NxvPackedVolume volume;

  const GridSpecification& Grid() const { return volume.levels.front().grid; }
  int CellSize() const { return volume.levels.back().voxels[0]; }
  int TileSize() const { return std::max(NxvBrickSize[0], this->CellSize()); }

  void CheckTile(const ChangedTile& tile) const
  {
    const GridSpecification grid = PartOf(this->Grid(), tile.block);
    for (std::size_t axis = 0; axis < 2; ++axis)
    {
      const int end = tile.block.end[axis];
      if (tile.block.begin[axis] % this->TileSize() != 0 ||
          (end % this->TileSize() != 0 && end != this->Grid().dimensions[axis]))
      {
        throw Error("voxels " + std::to_string(tile.block.begin[axis]) + " to " +
                    std::to_string(end - 1) + " along axis " + std::to_string(axis) +
                    " are not whole tiles of " + std::to_string(this->TileSize()));
      }
    }
    const VoxelsInOne cell = {this->CellSize(), this->CellSize(), 1};
    const VoxelBlock cells = CoarserBlock(tile.block, cell);
    // The centre of a file's geographic grid is not that of the grid that it was made for.
    if (grid.dimensions != tile.volume.grid.dimensions || grid.origin != tile.volume.grid.origin ||
        tile.block.Size(2) != this->Grid().dimensions[2] ||
        tile.changed.size() != static_cast<std::size_t>(cells.Size(0) * cells.Size(1)))
    {
      throw Error("a tile must have all voxels of its columns, and a mark for each of its cells");
    }
  }

  // Bricks of a column that change.
  std::vector<NewBrick> RepackColumn(const BrickColumn& column) const
  {
    const NxvPackedLevel& level = volume.levels[column.level];
    const auto [across, rows, layers] = BricksAlong(level.grid.dimensions, NxvBrickSize);
    const int first = (column.y * across + column.x) * layers;
    std::vector<NewBrick> made;
    for (std::size_t array = 0; array < level.arrays.size(); ++array)
    {
      for (int z = 0; z < layers; ++z)
      {
        const auto number = static_cast<std::size_t>(first + z);
        const NxvPackedArray& packed = level.arrays[array];
        const VoxelBlock voxels =
          BrickAt({column.x, column.y, z}, level.grid.dimensions, NxvBrickSize);
        auto brick = NamingTheFile(
          path, [&] { return Repack(packed, array, packed.bricks[number], voxels, column.parts); });
        if (brick)
        {
          made.push_back({column.level, array, number, std::move(*brick)});
        }
      }
    }
    return made;
  }

  // What a tile has of a level: `made` is the tile's volume in the voxels of that level.
  TilePart PartOfTile(const ChangedTile& tile, std::size_t number, const VoxelBlock& block,
    const GriddedVolume& made) const
  {
    const NxvPackedLevel& level = volume.levels[number];
    TilePart part = PartOfLevel(level, volume.exact, block, made);
    part.changed = MarkedCells(block, this->CellSize() / level.voxels[0], tile.changed);
    return part;
  }

  std::vector<NewBrick> RepackFinest(const TilePart& part) const
  {
    std::vector<NewBrick> made;
    ForEachSquare(part.block, NxvBrickSize[0],
      [&](int x, int y)
      {
        std::vector<NewBrick> bricks = this->RepackColumn({0, x, y, {&part}});
        std::move(bricks.begin(), bricks.end(), std::back_inserter(made));
      });
    return made;
  }

  // Packs a tile's volume, and makes its parts of coarser levels, each of the exact values of the
  // one before.
  PackedTile Pack(ChangedTile tile) const
  {
    this->CheckTile(tile);
    PackedTile packed;
    packed.block = tile.block;
    packed.bricks = this->RepackFinest(this->PartOfTile(tile, 0, tile.block, tile.volume));
    VoxelBlock block = tile.block;
    GriddedVolume made = std::move(tile.volume);
    for (std::size_t number = 1; number < volume.levels.size(); ++number)
    {
      const NxvPackedLevel& level = volume.levels[number];
      const VoxelsInOne voxels = VoxelsBetween(volume.levels[number - 1].voxels, level.voxels);
      block = CoarserBlock(block, voxels);
      GriddedVolume coarser = VolumeLike(made, PartOf(level.grid, block));
      SetCoarser(made, voxels, 0, coarser);
      made = std::move(coarser);
      packed.coarser.push_back(this->PartOfTile(tile, number, block, made));
    }
    return packed;
  }

  void RequireThatNoneOverlap(const std::vector<PackedTile>& tiles) const
  {
    std::set<std::pair<int, int>> taken;
    for (const PackedTile& tile : tiles)
    {
      ForEachSquare(tile.block, this->TileSize(),
        [&taken](int x, int y)
        {
          if (!taken.emplace(x, y).second)
          {
            throw Error("tiles that are replaced together must not overlap");
          }
        });
    }
  }

  void Put(std::vector<NewBrick>& bricks)
  {
    for (NewBrick& each : bricks)
    {
      volume.levels[each.level].arrays[each.array].bricks[each.number] = std::move(each.brick);
    }
  }
};

namespace
{

// The columns of bricks of coarser levels that tiles reach into.
std::vector<BrickColumn> CoarserColumns(const std::vector<PackedTile>& tiles)
{
  std::map<std::tuple<std::size_t, int, int>, std::vector<const TilePart*>> parts;
  for (const PackedTile& tile : tiles)
  {
    for (std::size_t i = 0; i < tile.coarser.size(); ++i)
    {
      const TilePart& part = tile.coarser[i];
      ForEachSquare(part.block, NxvBrickSize[0],
        [&](int x, int y) {
          parts[{i + 1, x, y}].push_back(&part);
        });
    }
  }
  std::vector<BrickColumn> columns;
  for (auto& [place, found] : parts)
  {
    const auto& [level, x, y] = place;
    columns.push_back({level, x, y, std::move(found)});
  }
  return columns;
}

} // namespace

NxvPatcher::NxvPatcher(const std::filesystem::path& path)
  : impl(new Impl{path, NxvPackedVolume::Read(path)})
{
}

NxvPatcher::~NxvPatcher() = default;

const GridSpecification& NxvPatcher::Grid() const
{
  return impl->Grid();
}

int NxvPatcher::CellSize() const
{
  return impl->CellSize();
}

int NxvPatcher::TileSize() const
{
  return impl->TileSize();
}

// Bricks take their places when all are made: until then nothing has changed.
void NxvPatcher::Replace(std::size_t count,
  const std::function<std::optional<ChangedTile>(std::size_t number)>& make, const RangeLoop& loop)
{
  std::vector<std::optional<PackedTile>> made(count);
  RunEach(loop, count,
    [&](std::size_t number)
    {
      if (std::optional<ChangedTile> tile = make(number))
      {
        made[number] = impl->Pack(std::move(*tile));
      }
    });
  std::vector<PackedTile> tiles;
  for (std::optional<PackedTile>& each : made)
  {
    if (each)
    {
      tiles.push_back(std::move(*each));
    }
  }
  impl->RequireThatNoneOverlap(tiles);
  const std::vector<BrickColumn> columns = CoarserColumns(tiles);
  std::vector<std::vector<NewBrick>> coarser(columns.size());
  RunEach(loop, columns.size(),
    [&](std::size_t number) { coarser[number] = impl->RepackColumn(columns[number]); });
  for (PackedTile& tile : tiles)
  {
    impl->Put(tile.bricks);
  }
  for (std::vector<NewBrick>& bricks : coarser)
  {
    impl->Put(bricks);
  }
}

void NxvPatcher::Write(const std::filesystem::path& path, const GriddedVolume& description) const
{
  impl->volume.Write(path, description);
}

std::size_t NxvPatcher::MemoryBytes() const
{
  return impl->volume.MemoryBytes();
}

} // namespace nexrad

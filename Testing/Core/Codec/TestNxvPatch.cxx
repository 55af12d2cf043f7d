// SPDX-License-Identifier: BSD-3-Clause
// A file of which parts are replaced is, byte for byte, that of the whole changed volume.
#include "nexrad/Codec/NxvPatch.h"

#include "nexrad/Codec/NxvFile.h"
#include "nexrad/Codec/NxvLevels.h"
#include "nexrad/Grid/GriddedVolume.h"

#include "BrickFile.h"
#include "ErrorMessage.h"
#include "TestData.h"
#include "VolumeMaker.h"
#include "nexrad/System/Error.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <fstream>
#include <functional>
#include <memory>
#include <random>

using namespace nexrad;
using nexrad::testing::AddAncillary;
using nexrad::testing::FileContent;
using nexrad::testing::MakeGriddedVolume;
using nexrad::testing::MakeMixedVolume;
using nexrad::testing::MessageOf;
using nexrad::testing::TakePart;
using nexrad::testing::TemporaryFolder;
using nexrad::testing::WriteBricks;

namespace
{

namespace fs = std::filesystem;

// All tiles of a grid.
std::vector<VoxelBlock> TilesOf(const GridSpecification& grid, int size)
{
  std::vector<VoxelBlock> tiles;
  for (int y = 0; y < grid.dimensions[1]; y += size)
  {
    for (int x = 0; x < grid.dimensions[0]; x += size)
    {
      tiles.push_back({{x, y, 0}, {std::min(x + size, grid.dimensions[0]),
                                    std::min(y + size, grid.dimensions[1]), grid.dimensions[2]}});
    }
  }
  return tiles;
}

template <class Value>
void CopyVoxel(const std::vector<Value>& from, std::size_t voxel, std::vector<Value>& to)
{
  if (!from.empty())
  {
    to[voxel] = from[voxel];
  }
}

void CopyVoxel(const GriddedVolume& from, std::size_t voxel, GriddedVolume& to)
{
  CopyVoxel(from.values, voxel, to.values);
  CopyVoxel(from.states, voxel, to.states);
  CopyVoxel(from.ancillary.age, voxel, to.ancillary.age);
  CopyVoxel(from.ancillary.radars, voxel, to.ancillary.radars);
  CopyVoxel(from.ancillary.weight, voxel, to.ancillary.weight);
  CopyVoxel(from.ancillary.nearestSite, voxel, to.ancillary.nearestSite);
  for (std::size_t i = 0; i < from.further.size(); ++i)
  {
    CopyVoxel(from.further[i], voxel, to.further[i]);
  }
}

// A volume that changes, and a patcher of its file.
class Changing
{
public:
  explicit Changing(GriddedVolume theVolume, std::optional<NxvEncoding> theEncoding = {})
    : volume(std::move(theVolume))
    , encoding(theEncoding)
  {
    WriteBricks(this->Before(), volume, encoding);
    patcher = std::make_unique<NxvPatcher>(this->Before());
    tiles = TilesOf(volume.grid, patcher->TileSize());
  }

  fs::path Before() const { return folder.Path() / "before.nxv"; }
  NxvPatcher& Patcher() { return *patcher; }
  const std::vector<VoxelBlock>& Tiles() const { return tiles; }

  // The tile with what another volume has of it, some cells of it marked; the volume takes these.
  ChangedTile Take(const GriddedVolume& other, std::size_t number,
    const std::function<bool(int x, int y)>& changes)
  {
    const int cell = patcher->CellSize();
    const VoxelBlock& block = tiles[number];
    ChangedTile tile{block, TakePart(other, block), {}};
    for (int y = block.begin[1]; y < block.end[1]; y += cell)
    {
      for (int x = block.begin[0]; x < block.end[0]; x += cell)
      {
        tile.changed.push_back(changes(x, y) ? 1 : 0);
        if (tile.changed.back() != 0)
        {
          this->TakeCell(other, block, x, y);
        }
      }
    }
    return tile;
  }

  // Replaces some cells of some tiles by those of another volume.
  void ReplaceSome(const GriddedVolume& other, unsigned seed, const RangeLoop& loop = {})
  {
    std::mt19937 random(seed);
    std::vector<std::optional<ChangedTile>> made(tiles.size());
    for (std::size_t i = 0; i < tiles.size(); ++i)
    {
      if (random() % 3 != 0)
      {
        const unsigned share = 1 + random() % 3;
        made[i] = this->Take(other, i, [&](int, int) { return random() % 4 < share; });
      }
    }
    patcher->Replace(
      made.size(), [&made](std::size_t number) { return made[number]; }, loop);
  }

  std::string Patched() const
  {
    patcher->Write(folder.Path() / "patched.nxv", volume);
    return FileContent(folder.Path() / "patched.nxv");
  }

  void ExpectTheFileOfTheWhole() const
  {
    WriteBricks(folder.Path() / "whole.nxv", volume, encoding);
    EXPECT_TRUE(this->Patched() == FileContent(folder.Path() / "whole.nxv"));
  }

  GriddedVolume volume;

private:
  void TakeCell(const GriddedVolume& other, const VoxelBlock& block, int left, int lower)
  {
    const int cell = patcher->CellSize();
    const auto [width, rows, layers] = volume.grid.dimensions;
    for (int z = 0; z < layers; ++z)
    {
      for (int y = lower; y < std::min(lower + cell, block.end[1]); ++y)
      {
        for (int x = left; x < std::min(left + cell, block.end[0]); ++x)
        {
          CopyVoxel(other, static_cast<std::size_t>(x + width * (y + rows * z)), volume);
        }
      }
    }
  }

  std::optional<NxvEncoding> encoding;
  TemporaryFolder folder;
  std::unique_ptr<NxvPatcher> patcher;
  std::vector<VoxelBlock> tiles;
};

GriddedVolume MakeTwoMoments(const std::array<int, 3>& dimensions, int seed = 0)
{
  return JoinMoments({MakeMixedVolume(MomentName::REF, dimensions, seed),
    MakeMixedVolume(MomentName::VEL, dimensions, seed)});
}

// Without the two states that take arrays of their own.
GriddedVolume WithoutStates(GriddedVolume volume)
{
  for (VoxelState& state : volume.states)
  {
    const bool own = state == VoxelState::RangeFolded || state == VoxelState::Filtered;
    state = own ? VoxelState::NoEcho : state;
  }
  for (GriddedVolume& further : volume.further)
  {
    further = WithoutStates(std::move(further));
  }
  return volume;
}

bool Always(int, int)
{
  return true;
}

} // namespace

// Two coarser levels with odd numbers of voxels, three, and none.
TEST(NxvPatch, IsTheFileOfTheWholeVolume)
{
  struct Case
  {
    std::array<int, 3> dimensions;
    NxvEncoding encoding;
    int cell;
  };
  for (const auto& [dimensions, encoding, cell] :
    {Case{{1030, 75, 34}, NxvEncoding::RadarSteps, 4}, {{2100, 67, 3}, NxvEncoding::RadarSteps, 8},
      {{1030, 67, 3}, NxvEncoding::Float, 4}, {{150, 140, 11}, NxvEncoding::RadarSteps, 1}})
  {
    Changing changing(MakeMixedVolume(MomentName::REF, dimensions), encoding);
    EXPECT_EQ(changing.Patcher().CellSize(), cell);
    EXPECT_EQ(changing.Patcher().TileSize(), 64);
    for (const int round : {1, 2})
    {
      const GriddedVolume other = MakeMixedVolume(MomentName::REF, dimensions, round);
      changing.ReplaceSome(other, static_cast<unsigned>(round));
      changing.ExpectTheFileOfTheWhole();
    }
  }
}

TEST(NxvPatch, ReplacesAllMomentsAndAncillaryArrays)
{
  const auto make = [](int seed)
  {
    GriddedVolume volume = MakeTwoMoments({600, 70, 9}, seed);
    AddAncillary(volume);
    AddAncillary(volume.further.front());
    std::reverse(volume.ancillary.age.begin(), volume.ancillary.age.end());
    return volume;
  };
  Changing changing(make(0));
  changing.ReplaceSome(make(1), 5);
  changing.ExpectTheFileOfTheWhole();
  const GriddedVolume read = ReadNxv(changing.Before());
  EXPECT_NE(read.ancillary.age, changing.volume.ancillary.age);
}

// The order of the arrays in a file is that in which its bands need them.
TEST(NxvPatch, StatesOfTheirOwnAppearAndVanish)
{
  const std::array<int, 3> dimensions = {600, 200, 3};
  const GriddedVolume with = MakeTwoMoments(dimensions);
  Changing changing(WithoutStates(with));
  const GriddedVolume without = changing.volume;
  const auto replace = [&](const GriddedVolume& other, const std::vector<std::size_t>& numbers)
  {
    changing.Patcher().Replace(
      numbers.size(), [&](std::size_t i) { return changing.Take(other, numbers[i], Always); });
    changing.ExpectTheFileOfTheWhole();
  };
  const std::string before = changing.Patched();
  GriddedVolume first = without;
  first.states = with.states;
  replace(first, {32}); // of the first moment, in the upper rows
  replace(with, {11, 3});
  EXPECT_NE(changing.Patched().find("VEL_state"), std::string::npos);
  replace(without, {3});
  replace(without, {32, 11});
  EXPECT_TRUE(changing.Patched() == before);
}

TEST(NxvPatch, ThreadsMakeTheSameFile)
{
  const std::array<int, 3> dimensions = {600, 139, 5};
  Changing one(MakeTwoMoments(dimensions));
  Changing several(MakeTwoMoments(dimensions));
  const GriddedVolume other = MakeTwoMoments(dimensions, 1);
  one.ReplaceSome(other, 3);
  several.ReplaceSome(other, 3, ThreadLoop(4));
  EXPECT_TRUE(several.Patched() == one.Patched());
  several.ExpectTheFileOfTheWhole();
}

// Several tiles, also with an edge of the grid, may be one block.
TEST(NxvPatch, TilesMayBeJoined)
{
  const std::array<int, 3> dimensions = {600, 139, 5};
  Changing changing(MakeMixedVolume(MomentName::REF, dimensions));
  const GriddedVolume other = MakeMixedVolume(MomentName::REF, dimensions, 1);
  const VoxelBlock block{{448, 64, 0}, {600, 139, 5}};
  ChangedTile tile{block, TakePart(other, block), {}};
  tile.changed.assign(std::size_t(152 / 2) * 38, 1);
  for (std::size_t number : {17U, 18U, 19U, 27U, 28U, 29U})
  {
    changing.Take(other, number, Always);
  }
  changing.Patcher().Replace(1, [&](std::size_t) { return tile; });
  changing.ExpectTheFileOfTheWhole();
}

TEST(NxvPatch, WhatIsNotReplacedStays)
{
  Changing changing(MakeTwoMoments({600, 70, 9}));
  const std::string before = FileContent(changing.Before());
  EXPECT_TRUE(changing.Patched() == before);
  const std::size_t bytes = changing.Patcher().MemoryBytes();
  EXPECT_GT(bytes, before.size() / 2);
  const GriddedVolume other = MakeTwoMoments({600, 70, 9}, 1);
  ChangedTile unmarked{changing.Tiles()[0], TakePart(other, changing.Tiles()[0]), {}};
  unmarked.changed.assign(32 * 32, 0);
  changing.Patcher().Replace(
    2, [&](std::size_t number) { return number == 0 ? std::nullopt : std::optional(unmarked); });
  EXPECT_TRUE(changing.Patched() == before);
  EXPECT_EQ(changing.Patcher().MemoryBytes(), bytes);
  // The description alone is new.
  changing.volume.time = *ParseIso8601("2006-03-12T18:10:00.000Z");
  changing.volume.notes = {"KEAX: a note"};
  changing.ExpectTheFileOfTheWhole();
}

TEST(NxvPatch, TilesThatDoNotFitAreRefused)
{
  Changing changing(MakeTwoMoments({600, 139, 5}));
  const std::string before = changing.Patched();
  const GriddedVolume other = MakeTwoMoments({600, 139, 5}, 1);
  const ChangedTile whole = [&]
  {
    ChangedTile tile{changing.Tiles()[1], TakePart(other, changing.Tiles()[1]), {}};
    tile.changed.assign(32 * 32, 1);
    return tile;
  }();
  const auto errorOf = [&](const ChangedTile& second)
  {
    const std::vector<ChangedTile> tiles = {whole, second};
    return MessageOf(
      [&] { changing.Patcher().Replace(2, [&](std::size_t number) { return tiles[number]; }); });
  };
  EXPECT_NE(errorOf(whole).find("must not overlap"), std::string::npos);
  ChangedTile tile = whole;
  tile.block = {{32, 0, 0}, {96, 64, 5}};
  EXPECT_NE(errorOf(tile).find("voxels 32 to 95 along axis 0 are not whole tiles of 64"),
    std::string::npos);
  tile.block = {{128, 0, 0}, {192, 64, 5}};
  EXPECT_NE(errorOf(tile).find("all voxels of its columns"), std::string::npos);
  tile = whole;
  tile.changed.pop_back();
  EXPECT_NE(errorOf(tile).find("a mark for each"), std::string::npos);
  tile = whole;
  tile.volume.further.clear();
  EXPECT_NE(errorOf(tile).find("must have the array \"VEL\""), std::string::npos);
  tile = whole;
  AddAncillary(tile.volume);
  EXPECT_NE(errorOf(tile).find("the array \"REF_age\" of a tile"), std::string::npos);
  tile = whole;
  tile.volume.further.front() = TakePart(tile.volume.further.front(), {{0, 0, 0}, {64, 64, 4}});
  EXPECT_NE(errorOf(tile).find("the array \"VEL\" of a tile"), std::string::npos);
  tile = whole;
  tile.volume.fill = -40.0F;
  EXPECT_NE(errorOf(tile).find("the array \"REF\" of a tile"), std::string::npos);
  EXPECT_TRUE(changing.Patched() == before);
}

TEST(NxvPatch, OtherFilesAreRefused)
{
  const TemporaryFolder folder;
  const fs::path path = folder.Path() / "file.nxv";
  const auto error = [&path]
  {
    const std::string message = MessageOf([&path] { const NxvPatcher patcher(path); });
    EXPECT_EQ(message.find('\n'), std::string::npos);
    return message;
  };
  EXPECT_NE(error().find("file.nxv: cannot be read"), std::string::npos);
  const GriddedVolume volume = MakeMixedVolume(MomentName::REF, {600, 70, 5});
  WriteNxv(path, volume);
  EXPECT_NE(error().find("array \"REF\": it must be in bricks"), std::string::npos);
  {
    NxvBandWriter rows(
      path, MakeGriddedVolume({1100, 200, 3}).grid, VoxelBlock{{0, 0, 0}, {1100, 128, 3}});
    const GriddedVolume all = MakeMixedVolume(MomentName::REF, {1100, 200, 3});
    rows.Add(TakePart(all, {{0, 0, 0}, {1100, 64, 3}}));
    rows.Add(TakePart(all, {{0, 64, 0}, {1100, 128, 3}}));
    rows.Commit();
  }
  EXPECT_NE(error().find("file.nxv: its levels must be"), std::string::npos);
  WriteBricks(path, volume);
  EXPECT_EQ(error(), "");
  std::string content = FileContent(path);
  content[content.size() - 20] ^= 1; // in the last array of the coarser level
  std::ofstream(path, std::ios::binary) << content;
  EXPECT_NE(error().find("array \"REF_filtered\": its CRC-32 is wrong"), std::string::npos);
  std::ofstream(path, std::ios::binary) << content.substr(0, content.size() - 1);
  EXPECT_NE(error().find("file.nxv: byte "), std::string::npos);
}

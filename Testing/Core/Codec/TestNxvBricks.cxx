// SPDX-License-Identifier: BSD-3-Clause
// Volumes in bricks hold what the same volumes as a whole hold, and can be read in parts.
#include "nexrad/Codec/NxvBricks.h"
#include "nexrad/Codec/NxvFile.h"
#include "nexrad/Grid/GriddedVolume.h"

#include "BrickFile.h"
#include "Comparison/VolumeComparison.h"
#include "ErrorMessage.h"
#include "TestData.h"
#include "Tolerance.h"
#include "VolumeMaker.h"
#include "nexrad/System/Error.h"

#include <gtest/gtest.h>

#include <fstream>
#include <random>

using namespace nexrad;
using nexrad::testing::AddAncillary;
using nexrad::testing::ExpectSameVolume;
using nexrad::testing::FileContent;
using nexrad::testing::MakeGriddedVolume;
using nexrad::testing::MessageOf;
using nexrad::testing::RowsFrom;
using nexrad::testing::TakePart;
using nexrad::testing::TemporaryFolder;
using nexrad::testing::WriteBricks;

namespace
{

namespace fs = std::filesystem;

// Three bands of bricks, all smaller at the upper faces. Voxels are filtered in the second band
// alone and range folded in the last alone; a corner of more than a brick is not scanned.
GriddedVolume MakeLarge(MomentName moment = MomentName::REF)
{
  GriddedVolume volume = MakeGriddedVolume({150, 140, 11});
  volume.moment = moment;
  const auto set = [&volume](int x, int y, int z, VoxelState state)
  {
    const auto at = static_cast<std::size_t>(x + 150 * (y + 140 * z));
    volume.states[at] = state;
    volume.values[at] = volume.fill;
  };
  for (int z = 0; z < 8; ++z)
  {
    for (int y = 0; y < 64; ++y)
    {
      for (int x = 0; x < 70; ++x)
      {
        set(x, y, z, VoxelState::NotScanned);
      }
    }
  }
  set(100, 70, 9, VoxelState::Filtered);
  set(3, 139, 0, VoxelState::RangeFolded);
  set(149, 139, 10, VoxelState::RangeFolded);
  return volume;
}

// What a file of the whole volume holds.
GriddedVolume ReadWhole(
  const fs::path& path, const GriddedVolume& volume, std::optional<NxvEncoding> encoding = {})
{
  WriteNxv(path, volume, encoding);
  return ReadNxv(path);
}

} // namespace

TEST(NxvBricks, HoldWhatAFileOfTheWholeHolds)
{
  const TemporaryFolder folder;
  for (const MomentName moment : {MomentName::REF, MomentName::VEL, MomentName::ZDR})
  {
    for (const auto encoding : {NxvEncoding::RadarSteps, NxvEncoding::Float})
    {
      const GriddedVolume volume = MakeLarge(moment);
      WriteBricks(folder.Path() / "bricks.nxv", volume, encoding);
      const GriddedVolume read = ReadNxv(folder.Path() / "bricks.nxv");
      ExpectSameVolume(read, ReadWhole(folder.Path() / "whole.nxv", volume, encoding));
      EXPECT_EQ(read.states, volume.states);
    }
  }
}

// Slow velocities, which a whole file has in a byte, take two.
TEST(NxvBricks, VelocitiesAreRoundedAsInAByte)
{
  const TemporaryFolder folder;
  GriddedVolume volume = MakeLarge(MomentName::VEL);
  for (std::size_t i = 0; i < volume.values.size(); ++i)
  {
    volume.values[i] = volume.states[i] == VoxelState::Echo
                         ? -60.0F + 0.17F * static_cast<float>(i % 700)
                         : volume.fill;
  }
  WriteBricks(folder.Path() / "bricks.nxv", volume);
  const GriddedVolume whole = ReadWhole(folder.Path() / "whole.nxv", volume);
  EXPECT_TRUE(HasNxvCodes(folder.Path() / "whole.nxv"));
  EXPECT_FALSE(HasNxvCodes(folder.Path() / "bricks.nxv"));
  ExpectSameVolume(ReadNxv(folder.Path() / "bricks.nxv"), whole);
}

TEST(NxvBricks, HoldSeveralMomentsAndExactAncillaryArrays)
{
  const TemporaryFolder folder;
  GriddedVolume first = MakeLarge();
  AddAncillary(first);
  // In the corner nothing was scanned.
  for (std::size_t i = 0; i < first.states.size(); ++i)
  {
    if (first.states[i] == VoxelState::NotScanned)
    {
      first.ancillary.age[i] = 0.0F;
      first.ancillary.weight[i] = 0.0F;
      first.ancillary.radars[i] = 0;
      first.ancillary.nearestSite[i] = AncillaryArrays::NoSite;
    }
  }
  const GriddedVolume volume = JoinMoments({first, MakeLarge(MomentName::RHO)});
  WriteBricks(folder.Path() / "bricks.nxv", volume);
  const GriddedVolume read = ReadNxv(folder.Path() / "bricks.nxv");
  EXPECT_EQ(read.ancillary.age, first.ancillary.age);
  EXPECT_EQ(read.ancillary.weight, first.ancillary.weight);
  EXPECT_EQ(read.ancillary.radars, first.ancillary.radars);
  EXPECT_EQ(read.ancillary.nearestSite, first.ancillary.nearestSite);
  ASSERT_EQ(read.further.size(), 1U);
  EXPECT_EQ(read.further[0].states, volume.further[0].states);
  NxvReadOptions second;
  second.moments = {MomentName::RHO};
  EXPECT_EQ(ReadNxv(folder.Path() / "bricks.nxv", second).values, read.further[0].values);
}

TEST(NxvBricks, ABoxIsThatPartOfTheWhole)
{
  const TemporaryFolder folder;
  const fs::path bricks = folder.Path() / "bricks.nxv";
  const fs::path whole = folder.Path() / "whole.nxv";
  const GriddedVolume volume = JoinMoments({MakeLarge(), MakeLarge(MomentName::VEL)});
  WriteBricks(bricks, volume);
  const GriddedVolume expected = ReadWhole(whole, volume);
  std::mt19937 random(7);
  for (int i = 0; i < 40; ++i)
  {
    VoxelBlock box;
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      std::uniform_int_distribution<int> place(0, volume.grid.dimensions[axis] - 1);
      const int one = place(random);
      const int other = place(random);
      box.begin[axis] = std::min(one, other);
      box.end[axis] = std::max(one, other) + 1;
    }
    NxvReadOptions options;
    options.block = box;
    const GriddedVolume part = TakePart(expected, box);
    ExpectSameVolume(ReadNxv(bricks, options), part);
    ExpectSameVolume(ReadNxv(whole, options), part); // cut out of all of it
    options.moments = {MomentName::REF};
    const std::optional<CodedVolume> codes = ReadNxvCodes(bricks, options);
    ASSERT_TRUE(codes);
    EXPECT_EQ(codes->volume.grid, part.grid);
    EXPECT_FALSE(ReadNxvCodes(bricks, options, true));
  }
  NxvReadOptions outside;
  outside.block = VoxelBlock{{0, 0, 0}, {151, 1, 1}};
  EXPECT_NE(MessageOf([&] { ReadNxv(bricks, outside); }).find("bricks.nxv: voxels 0 to 150"),
    std::string::npos);
}

// A box needs no more memory and no other bytes than its bricks.
TEST(NxvBricks, ABoxIsReadWithoutTheRest)
{
  const TemporaryFolder folder;
  const fs::path path = folder.Path() / "bricks.nxv";
  const GriddedVolume volume = MakeLarge();
  WriteBricks(path, volume);
  std::string content = FileContent(path);
  content[content.size() - 20] ^= 1; // in the last brick of an array of the last band
  std::ofstream(path, std::ios::binary) << content;
  EXPECT_NE(MessageOf([&] { ReadNxv(path); }), "");
  NxvReadOptions box;
  box.block = VoxelBlock{{90, 10, 2}, {100, 60, 9}};
  box.maximumBytes = box.block->VoxelCount() * 6;
  EXPECT_EQ(ReadNxv(path, box).states, TakePart(volume, *box.block).states);
  box.block->end[2] = 10;
  EXPECT_NE(MessageOf([&] { ReadNxv(path, box); }).find("more memory"), std::string::npos);
}

TEST(NxvBricks, TellHowManyVoxelsDiffer)
{
  const TemporaryFolder folder;
  const fs::path bricks = folder.Path() / "bricks.nxv";
  const GriddedVolume volume = MakeLarge();
  WriteBricks(bricks, volume);
  constexpr std::size_t brick = 64 * 64 * 8; // the corner that is not scanned has one
  EXPECT_EQ(CountVoxelsThatDiffer(bricks), volume.grid.VoxelCount() - brick);
  NxvReadOptions box;
  box.block = VoxelBlock{{0, 0, 0}, {64, 64, 8}};
  EXPECT_EQ(CountVoxelsThatDiffer(bricks, box), 0U);
  box.block->end[0] = 65; // and a part of the next brick
  EXPECT_EQ(CountVoxelsThatDiffer(bricks, box), brick);
  const fs::path whole = folder.Path() / "whole.nxv";
  WriteNxv(whole, volume);
  EXPECT_EQ(CountVoxelsThatDiffer(whole, box), box.block->VoxelCount());
}

// Of 16 million voxels that are alike.
TEST(NxvBricks, WhatIsAlikeTakesNoSpace)
{
  const TemporaryFolder folder;
  GridSpecification grid = MakeGriddedVolume().grid;
  grid.dimensions = {512, 512, 64};
  GriddedVolume band = MakeGriddedVolume();
  band.grid = PartOf(grid, RowsFrom(grid, 0));
  band.values.assign(band.grid.VoxelCount(), band.fill);
  band.states.assign(band.grid.VoxelCount(), VoxelState::NotScanned);
  NxvBandWriter writer(folder.Path() / "empty.nxv", grid);
  for (int row = 0; row < 512; row += NxvBandWriter::Rows)
  {
    band.grid = PartOf(grid, RowsFrom(grid, row));
    writer.Add(band);
  }
  writer.Commit();
  EXPECT_AT_MOST(fs::file_size(folder.Path() / "empty.nxv"), 900U, "bytes of an empty volume");
  const GriddedVolume read = ReadNxv(folder.Path() / "empty.nxv");
  EXPECT_EQ(read.states, std::vector<VoxelState>(grid.VoxelCount(), VoxelState::NotScanned));
}

TEST(NxvBricks, BandsMustBeThoseOfTheGrid)
{
  const TemporaryFolder folder;
  const GriddedVolume volume = MakeLarge();
  const auto errorOf = [&](std::initializer_list<int> rows)
  {
    return MessageOf(
      [&]
      {
        NxvBandWriter writer(folder.Path() / "bricks.nxv", volume.grid);
        for (const int row : rows)
        {
          writer.Add(TakePart(volume, RowsFrom(volume.grid, row)));
        }
      });
  };
  EXPECT_NE(errorOf({64}).find("bricks.nxv: bands must have 64 rows"), std::string::npos);
  EXPECT_NE(errorOf({0, 0}), "");
  EXPECT_NE(errorOf({0, 64, 128, 128}), "");
  EXPECT_FALSE(fs::exists(folder.Path() / "bricks.nxv"));
}

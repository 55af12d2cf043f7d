// SPDX-License-Identifier: BSD-3-Clause
// The coarser levels of a volume in bricks are what the rule says of the voxels that they replace.
#include "nexrad/Codec/NxvFile.h"
#include "nexrad/Codec/NxvLevels.h"
#include "nexrad/Grid/GriddedVolume.h"

#include "BrickFile.h"
#include "Comparison/VolumeComparison.h"
#include "ErrorMessage.h"
#include "TestData.h"
#include "Tolerance.h"
#include "VolumeMaker.h"
#include "nexrad/System/Error.h"

#include <gtest/gtest.h>

#include <cmath>
#include <fstream>

using namespace nexrad;
using nexrad::testing::ExpectSameVolume;
using nexrad::testing::FileContent;
using nexrad::testing::MakeGriddedVolume;
using nexrad::testing::MakeMixedVolume;
using nexrad::testing::MessageOf;
using nexrad::testing::RowsFrom;
using nexrad::testing::TakePart;
using nexrad::testing::TemporaryFolder;
using nexrad::testing::WriteBricks;

namespace
{

namespace fs = std::filesystem;

struct Expected
{
  VoxelState state = VoxelState::NotScanned;
  double value = 0.0;
};

// What a voxel is in place of those of a block, written down anew.
Expected OneOf(const GriddedVolume& volume, const VoxelBlock& block)
{
  std::vector<VoxelState> states;
  std::vector<double> echo;
  const auto& [nx, ny, nz] = volume.grid.dimensions;
  for (int z = block.begin[2]; z < block.end[2]; ++z)
  {
    for (int y = block.begin[1]; y < block.end[1]; ++y)
    {
      for (int x = block.begin[0]; x < block.end[0]; ++x)
      {
        const auto i = static_cast<std::size_t>(x + nx * (y + ny * z));
        states.push_back(volume.states[i]);
        if (volume.states[i] == VoxelState::Echo)
        {
          echo.push_back(static_cast<double>(volume.values[i]));
        }
      }
    }
  }
  const auto count = [&states](VoxelState state)
  { return std::count(states.begin(), states.end(), state); };
  for (const VoxelState state : {VoxelState::RangeFolded, VoxelState::Filtered})
  {
    if (count(state) > 0 && count(VoxelState::Echo) + count(VoxelState::NoEcho) == 0)
    {
      return {state, 0.0};
    }
  }
  if (count(VoxelState::Echo) == 0)
  {
    return {count(VoxelState::NoEcho) > 0 ? VoxelState::NoEcho : VoxelState::NotScanned, 0.0};
  }
  if (volume.moment == MomentName::VEL)
  {
    return {VoxelState::Echo, echo.front()};
  }
  double sum = 0.0;
  for (const double value : echo)
  {
    sum += volume.moment == MomentName::REF ? std::pow(10.0, value / 10.0) : value;
  }
  const auto echoes = static_cast<double>(echo.size());
  const auto measured = echoes + static_cast<double>(count(VoxelState::NoEcho));
  return {VoxelState::Echo,
    volume.moment == MomentName::REF ? 10.0 * std::log10(sum / measured) : sum / echoes};
}

GriddedVolume HalveAnew(const GriddedVolume& fine, const VoxelsInOne& voxels)
{
  GriddedVolume coarse = VolumeLike(fine, CoarserGrid(fine.grid, voxels));
  std::size_t i = 0;
  const auto& [nx, ny, nz] = coarse.grid.dimensions;
  for (int z = 0; z < nz; ++z)
  {
    for (int y = 0; y < ny; ++y)
    {
      for (int x = 0; x < nx; ++x, ++i)
      {
        VoxelBlock block{{x * voxels[0], y * voxels[1], z * voxels[2]}, {}};
        for (std::size_t axis = 0; axis < 3; ++axis)
        {
          block.end[axis] = std::min(block.begin[axis] + voxels[axis], fine.grid.dimensions[axis]);
        }
        const Expected expected = OneOf(fine, block);
        coarse.states[i] = expected.state;
        coarse.values[i] =
          expected.state == VoxelState::Echo ? static_cast<float>(expected.value) : coarse.fill;
      }
    }
  }
  return coarse;
}

double LargestDifference(const GriddedVolume& a, const GriddedVolume& b)
{
  double largest = 0.0;
  for (std::size_t i = 0; i < a.values.size(); ++i)
  {
    largest = std::max(largest, static_cast<double>(std::abs(a.values[i] - b.values[i])));
  }
  return largest;
}

NxvReadOptions OfLevel(std::size_t level)
{
  NxvReadOptions options;
  options.level = level;
  return options;
}

} // namespace

TEST(NxvLevels, HalveUntilTheyAreSmall)
{
  GridSpecification grid;
  grid.dimensions = {7000, 3500, 33};
  EXPECT_EQ(
    CoarserLevels(grid), (std::vector<VoxelsInOne>{{2, 2, 2}, {4, 4, 2}, {8, 8, 2}, {16, 16, 2}}));
  EXPECT_EQ(CoarserGrid(grid, {16, 16, 2}).dimensions, (std::array<int, 3>{438, 219, 17}));
  grid.dimensions = {512, 512, 4000};
  EXPECT_TRUE(CoarserLevels(grid).empty());
  grid.dimensions = {10, 1025, 1};
  EXPECT_EQ(CoarserLevels(grid), (std::vector<VoxelsInOne>{{2, 2, 1}, {4, 4, 1}}));
}

// The lower faces stay where they are.
TEST(NxvLevels, LieOverTheSameDomain)
{
  GridSpecification grid;
  grid.dimensions = {7, 6, 5};
  grid.origin = {100.0, -20.0, 250.0};
  grid.spacing = {10.0, 20.0, 500.0};
  const GridSpecification coarse = CoarserGrid(grid, {2, 3, 1});
  EXPECT_EQ(coarse.dimensions, (std::array<int, 3>{4, 2, 5}));
  EXPECT_EQ(coarse.spacing, (std::array<double, 3>{20.0, 60.0, 500.0}));
  EXPECT_EQ(coarse.origin, (std::array<double, 3>{105.0, 0.0, 250.0}));
}

TEST(NxvLevels, AreWhatTheirRuleSays)
{
  const TemporaryFolder folder;
  const fs::path path = folder.Path() / "levels.nxv";
  // Odd numbers of voxels, and bands of 64 and of 11 rows, of which halves are joined.
  const std::pair<MomentName, std::array<int, 3>> volumes[] = {{MomentName::REF, {1031, 139, 33}},
    {MomentName::VEL, {1027, 75, 3}}, {MomentName::RHO, {1025, 1, 5}}};
  for (const auto& [moment, dimensions] : volumes)
  {
    const GriddedVolume volume = MakeMixedVolume(moment, dimensions);
    WriteBricks(path, volume, {NxvEncoding::Float});
    const std::vector<GridSpecification> grids = ReadNxvLevels(path);
    ASSERT_EQ(grids.size(), 3U);
    GriddedVolume expected = volume;
    for (std::size_t level = 0; level < grids.size(); ++level)
    {
      const GriddedVolume read = ReadNxv(path, OfLevel(level));
      EXPECT_EQ(read.grid, grids[level]);
      EXPECT_EQ(read.states, expected.states);
      EXPECT_AT_MOST(LargestDifference(read, expected), 1e-5, "of a value, in single precision");
      expected = HalveAnew(expected, {2, 2, level == 0 && dimensions[2] == 33 ? 2 : 1});
    }
  }
}

// Of several moments, as codes: rounded once, however coarse.
TEST(NxvLevels, AreRoundedToTheStepsOfTheRadar)
{
  const TemporaryFolder folder;
  const fs::path path = folder.Path() / "levels.nxv";
  const std::array<int, 3> dimensions = {1030, 70, 3};
  const GriddedVolume volume = JoinMoments(
    {MakeMixedVolume(MomentName::REF, dimensions), MakeMixedVolume(MomentName::VEL, dimensions)});
  WriteBricks(path, volume);
  GriddedVolume expected = volume;
  expected.further.clear();
  for (std::size_t level = 1; level < 3; ++level)
  {
    expected = HalveAnew(expected, {2, 2, 1});
    const GriddedVolume read = ReadNxv(path, OfLevel(level));
    EXPECT_EQ(read.states, expected.states);
    EXPECT_AT_MOST(LargestDifference(read, expected), 0.2501, "dB, half a step");
    ASSERT_EQ(read.further.size(), 1U);
    EXPECT_EQ(read.further[0].grid, read.grid);
    NxvReadOptions second = OfLevel(level);
    second.moments = {MomentName::VEL};
    EXPECT_EQ(ReadNxv(path, second).values, read.further[0].values);
    second.moments = {MomentName::REF};
    const std::optional<CodedVolume> codes = ReadNxvCodes(path, second);
    ASSERT_TRUE(codes);
    EXPECT_EQ(codes->volume.grid, read.grid);
  }
}

TEST(NxvLevels, ABoxOfALevelIsThatPartOfIt)
{
  const TemporaryFolder folder;
  const fs::path path = folder.Path() / "levels.nxv";
  WriteBricks(path, MakeMixedVolume(MomentName::REF, {1030, 140, 9}));
  const GriddedVolume whole = ReadNxv(path, OfLevel(1));
  NxvReadOptions box = OfLevel(1);
  box.block = VoxelBlock{{60, 3, 1}, {513, 70, 9}};
  ExpectSameVolume(ReadNxv(path, box), TakePart(whole, *box.block));
  box.block->end[0] = 516; // of the finer grid
  EXPECT_NE(MessageOf([&] { ReadNxv(path, box); }).find("a grid that has 515"), std::string::npos);
}

TEST(NxvLevels, OneThatIsMissingIsRefused)
{
  const TemporaryFolder folder;
  const fs::path path = folder.Path() / "whole.nxv";
  WriteNxv(path, MakeGriddedVolume());
  EXPECT_EQ(ReadNxvLevels(path).size(), 1U);
  EXPECT_NE(MessageOf([&] { ReadNxv(path, OfLevel(1)); })
              .find("whole.nxv: the file has no level 1; its levels are 0 to 0"),
    std::string::npos);
}

namespace
{

// The rows of a grid from one part to another one.
VoxelBlock PartsFrom(const GridSpecification& grid, int first, int end)
{
  VoxelBlock rows = VoxelBlock::Of(grid);
  rows.begin[1] = first * NxvBandWriter::PartRows;
  rows.end[1] = std::min(end * NxvBandWriter::PartRows, grid.dimensions[1]);
  return rows;
}

void WritePart(const fs::path& path, const GriddedVolume& volume, const VoxelBlock& rows,
  std::optional<NxvEncoding> encoding = {})
{
  NxvBandWriter writer(path, volume.grid, rows, encoding);
  for (int row = rows.begin[1]; row < rows.end[1]; row += NxvBandWriter::Rows)
  {
    writer.Add(TakePart(volume, RowsFrom(volume.grid, row)));
  }
  writer.Commit();
}

// A volume of several moments, one of them folded in the last rows alone.
GriddedVolume MakeMoments(const std::array<int, 3>& dimensions)
{
  GriddedVolume volume = MakeMixedVolume(MomentName::REF, dimensions);
  GriddedVolume further = MakeMixedVolume(MomentName::VEL, dimensions);
  for (std::size_t i = 0; i < further.states.size() - 1; ++i)
  {
    further.states[i] =
      further.states[i] == VoxelState::RangeFolded ? VoxelState::NoEcho : further.states[i];
  }
  further.states.back() = VoxelState::RangeFolded;
  further.values.back() = further.fill;
  return nexrad::JoinMoments({volume, further});
}

} // namespace

// Rows that others packed make the same file as bands do: one level, three levels, and none.
TEST(NxvParts, AreJoinedToTheSameFile)
{
  const TemporaryFolder folder;
  for (const auto& dimensions : {std::array{600, 300, 5}, {40, 2100, 3}, {70, 300, 9}})
  {
    GriddedVolume volume = MakeMoments(dimensions);
    if (dimensions[0] == 600)
    {
      volume.grid.axes = GridAxes::Geographic;
      volume.grid.spacing = {0.01, 0.01, 500.0};
      volume.grid.origin = {-93.7, 37.2, 0.0};
      volume.further.front().grid = volume.grid;
    }
    const int parts = (dimensions[1] - 1) / NxvBandWriter::PartRows + 1;
    for (const auto encoding : {NxvEncoding::RadarSteps, NxvEncoding::Float})
    {
      WriteBricks(folder.Path() / "whole.nxv", volume, encoding);
      NxvBandWriter writer(folder.Path() / "joined.nxv", volume.grid, encoding);
      for (const auto& [first, end] : {std::pair{0, 1}, {1, parts}})
      {
        const fs::path part = folder.Path() / "part";
        WritePart(part, volume, PartsFrom(volume.grid, first, end), encoding);
        writer.AddPart(part);
      }
      writer.Commit();
      EXPECT_TRUE(
        FileContent(folder.Path() / "joined.nxv") == FileContent(folder.Path() / "whole.nxv"))
        << dimensions[0] << " columns";
    }
  }
}

TEST(NxvParts, ThatDoNotFollowAreRefused)
{
  const TemporaryFolder folder;
  const GriddedVolume volume = MakeMixedVolume(MomentName::REF, {600, 300, 5});
  const fs::path first = folder.Path() / "first";
  const fs::path second = folder.Path() / "second";
  WritePart(first, volume, PartsFrom(volume.grid, 0, 1));
  WritePart(second, volume, PartsFrom(volume.grid, 1, 3));
  const auto join = [&](const std::vector<fs::path>& parts)
  {
    return MessageOf(
      [&]
      {
        NxvBandWriter writer(folder.Path() / "joined.nxv", volume.grid);
        for (const fs::path& part : parts)
        {
          writer.AddPart(part);
        }
        writer.Commit();
      });
  };
  EXPECT_EQ(join({first, second}), "");
  fs::remove(folder.Path() / "joined.nxv");
  EXPECT_NE(join({second}).find("second: its rows do not follow"), std::string::npos);
  EXPECT_NE(join({first, first}).find("first: its rows do not follow"), std::string::npos);
  EXPECT_NE(
    join({first, second, second}).find("second: its rows do not follow"), std::string::npos);
  std::string bytes = FileContent(second);
  bytes[bytes.size() - 20] = static_cast<char>(bytes[bytes.size() - 20] ^ 1);
  std::ofstream(second, std::ios::binary) << bytes;
  EXPECT_NE(join({first, second}).find("second: "), std::string::npos);
  EXPECT_FALSE(fs::exists(folder.Path() / "joined.nxv"));
}

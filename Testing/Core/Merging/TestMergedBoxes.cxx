// SPDX-License-Identifier: BSD-3-Clause
// A box of a domain that is merged again in finer voxels, against the domain.
#include "nexrad/Merging/SeriesMerger.h"

#include "Scans/SyntheticScans.h"
#include "TestData.h"
#include "Tolerance.h"
#include "nexrad/System/Error.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>

namespace nexrad
{
namespace
{

using namespace std::chrono_literals;
using testing::TemporaryFolder;
using testing::WriteSyntheticScans;

std::unique_ptr<SeriesMerger> Open(
  const std::vector<std::filesystem::path>& inputs, MergeOptions options)
{
  options.grid.dimensions = {256, 256, 80};
  MergerSetup setup;
  setup.loop = ThreadLoop(2);
  setup.threads = 2;
  setup.anyOrder = true;
  auto merger = std::make_unique<SeriesMerger>(inputs, options, setup);
  merger->Open();
  return merger;
}

std::size_t Number(const GridSpecification& grid, int x, int y, int z)
{
  return static_cast<std::size_t>(x) +
         static_cast<std::size_t>(grid.dimensions[0]) *
           (static_cast<std::size_t>(y) +
             static_cast<std::size_t>(grid.dimensions[1]) * static_cast<std::size_t>(z));
}

// 60 km about the strongest echo at least 60 km inside the domain.
BoxRequest BoxAboutTheStorm(const GriddedVolume& volume)
{
  const GridSpecification& grid = volume.grid;
  const auto margin = static_cast<int>(60'000.0 / grid.spacing[0]);
  std::array<double, 2> place{};
  float best = -99.0F;
  const int level = grid.dimensions[2] / 8;
  for (int y = margin; y < grid.dimensions[1] - margin; ++y)
  {
    for (int x = margin; x < grid.dimensions[0] - margin; ++x)
    {
      const std::size_t voxel = Number(grid, x, y, level);
      if (volume.states[voxel] == VoxelState::Echo && volume.values[voxel] > best)
      {
        best = volume.values[voxel];
        place = {grid.Coordinate(0, x), grid.Coordinate(1, y)};
      }
    }
  }
  return {{place[0] - 30e3, place[0] + 30e3, place[1] - 30e3, place[1] + 30e3}};
}

// The fine voxels about the centre of a coarse one, as many as fill it: their mean, when they all
// have echo and lie within 3 dB.
std::optional<double> SmoothMean(
  const GriddedVolume& fine, const std::array<double, 3>& centre, const std::array<double, 3>& size)
{
  std::array<int, 3> first{};
  std::array<int, 3> last{};
  for (int axis = 0; axis < 3; ++axis)
  {
    const double index = (centre[axis] - fine.grid.origin[axis]) / fine.grid.spacing[axis];
    const double reach = 0.5 * (size[axis] / fine.grid.spacing[axis] - 1.0);
    first[axis] = static_cast<int>(std::lround(index - reach));
    last[axis] = static_cast<int>(std::lround(index + reach));
    if (first[axis] < 0 || last[axis] >= fine.grid.dimensions[axis])
    {
      return std::nullopt;
    }
  }
  double sum = 0.0;
  double least = 1e9;
  double most = -1e9;
  int count = 0;
  for (int z = first[2]; z <= last[2]; ++z)
  {
    for (int y = first[1]; y <= last[1]; ++y)
    {
      for (int x = first[0]; x <= last[0]; ++x)
      {
        const std::size_t voxel = Number(fine.grid, x, y, z);
        const double value = static_cast<double>(fine.values[voxel]);
        sum += value;
        ++count;
        least = fine.states[voxel] == VoxelState::Echo ? std::min(least, value) : -1e9;
        most = std::max(most, value);
      }
    }
  }
  return most - least <= 3.0 ? std::optional(sum / count) : std::nullopt;
}

// RMS difference of coarse voxels from the fine ones in them, in smooth echo, dB.
double Difference(const GriddedVolume& coarse, const GriddedVolume& fine)
{
  double squares = 0.0;
  int count = 0;
  for (std::size_t voxel = 0; voxel < coarse.values.size(); ++voxel)
  {
    const auto x = static_cast<int>(voxel % 256);
    const auto y = static_cast<int>(voxel / 256 % 256);
    const auto z = static_cast<int>(voxel / 256 / 256);
    const auto mean = SmoothMean(fine,
      {coarse.grid.Coordinate(0, x), coarse.grid.Coordinate(1, y), coarse.grid.Coordinate(2, z)},
      coarse.grid.spacing);
    if (mean && coarse.states[voxel] == VoxelState::Echo)
    {
      squares += std::pow(*mean - static_cast<double>(coarse.values[voxel]), 2);
      ++count;
    }
  }
  EXPECT_AT_LEAST(count, 6000, "voxels in smooth echo");
  return std::sqrt(squares / count);
}

} // namespace

TEST(MergedBoxes, AgreeWithTheDomainInSmoothEchoOfTheSyntheticDay)
{
  const TemporaryFolder folder;
  WriteSyntheticScans(folder.Path(), "KEAX", *ParseIso8601("2006-03-12T18:00:00Z"), 12min);
  const std::unique_ptr<SeriesMerger> merger = Open({folder.Path()}, {});
  const Time time = merger->Times().front();
  const GriddedVolume coarse = *merger->Merge(time);
  const GriddedVolume fine = *merger->MergeBox(time, BoxAboutTheStorm(coarse));
  EXPECT_TRUE(fine.synthetic);
  EXPECT_AT_MOST(Difference(coarse, fine), 0.43,
    "RMS difference of a box from the domain in smooth echo of the synthetic day, dB");
  EXPECT_TRUE(merger->Merge(time)->values == coarse.values) << "the box changes nothing";
}

TEST(MergedBoxes, AgreeWithTheDomainInSmoothEchoOfARealStorm)
{
  NEXRAD_REQUIRE_TEST_DATA(data);
  const std::unique_ptr<SeriesMerger> merger =
    Open({data / "level2/legacy/KTLX19990503_235621.gz"}, {});
  const Time time = merger->Times().front();
  const GriddedVolume coarse = *merger->Merge(time);
  const BoxRequest box = BoxAboutTheStorm(coarse);
  const GriddedVolume fine = *merger->MergeBox(time, box);
  EXPECT_EQ(fine.grid.dimensions, (std::array<int, 3>{240, 240, 80}));
  EXPECT_EQ(fine.sites, coarse.sites);
  EXPECT_AT_MOST(Difference(coarse, fine), 0.5,
    "RMS difference of a box from the domain in smooth echo of KTLX on 1999-05-03, dB");
}

TEST(MergedBoxes, AreOfTheMethodBeamAlone)
{
  NEXRAD_REQUIRE_TEST_DATA(data);
  MergeOptions options;
  options.method = MergeMethod::Thesis;
  const std::unique_ptr<SeriesMerger> merger =
    Open({data / "level2/legacy/KTLX19990503_235621.gz"}, options);
  EXPECT_THROW(merger->MergeBox(merger->Times().front(), {{0.0, 1e4, 0.0, 1e4}}), Error);
}

} // namespace nexrad

// SPDX-License-Identifier: BSD-3-Clause
#include "nexrad/Merging/MemoryNeed.h"

#include "ErrorMessage.h"
#include "Feed/TarMaker.h"
#include "Level2Bytes.h"
#include "TestData.h"
#include "nexrad/Merging/SeriesMerger.h"

#include <gtest/gtest.h>

#include <fstream>
#include <string>

using namespace nexrad;
using namespace nexrad::testing;

namespace
{

constexpr std::size_t gibibyte = std::size_t(1) << 30;
constexpr std::size_t voxels = std::size_t(256) * 256 * 128;
constexpr VolumeUse written = {1, 2};
const InputSizes twoFiles = {1, 2, 0};

MemoryNeed Need(const MergeOptions& options)
{
  return NeedOf(options, options.grid.dimensions, twoFiles, 2, written);
}

// What a need above the limit is refused with; "" when it is not.
std::string Refusal(const MergeOptions& options)
{
  return MessageOf([&] { RequireMemory(options, twoFiles, 2, written); });
}

double NumberAfter(const std::string& text, const std::string& before)
{
  return std::stod(text.substr(text.find(before) + before.size()));
}

} // namespace

// A value and a state of two volumes, and two bytes for the file.
TEST(MemoryNeed, CountsTheBytesOfVoxels)
{
  MergeOptions options;
  EXPECT_EQ(Need(options).voxels, voxels * (2 * 5 + 2));
  options.beam.ancillary = true; // age, number, weight, nearest radar
  EXPECT_EQ(Need(options).voxels, voxels * (2 * 15 + 2));
  options.moments = {MomentName::REF, MomentName::VEL};
  EXPECT_EQ(Need(options).voxels, voxels * (2 * 30 + 2));
}

// A code takes the place of value and state, but for a velocity.
TEST(MemoryNeed, CodesTakeAByte)
{
  MergeOptions options;
  options.beam.codes = true;
  EXPECT_EQ(Need(options).voxels, voxels * (2 * 1 + 2));
  options.moments = {MomentName::REF, MomentName::VEL};
  EXPECT_EQ(Need(options).voxels, voxels * (2 * 6 + 2));
}

TEST(MemoryNeed, OfOneTimeThereIsOneVolume)
{
  MergeOptions options;
  EXPECT_EQ(NeedOf(options, {8, 8, 8}, {}, 2, written).voxels, 512U * 7); // of one file
  options.begin = options.end = Time(std::chrono::hours(24));
  EXPECT_EQ(Need(options).voxels, voxels * 7);
  options.end = *options.end + std::chrono::minutes(5);
  EXPECT_EQ(Need(options).voxels, voxels * 12);
}

// Each radar's geometry counts, as far as the radar sees the grid.
TEST(MemoryNeed, ARefusalTellsOneNeed)
{
  MergeOptions options;
  options.grid.dimensions = {2000, 1000, 33};
  options.memoryLimit = {gibibyte / 2, "--memory"};
  const InputSizes inputs = {3, 6, 0};
  std::vector<double> needs; // GiB
  for (const bool known : {false, true})
  {
    const std::vector<Position> places = {
      {35.3, -97.3, 370.0}, {45.5, -122.9, 400.0}, {25.6, -80.4, 30.0}};
    const std::string text = MessageOf([&]
      { RequireMemory(options, inputs, 2, written, known ? places : std::vector<Position>()); });
    needs.push_back(NumberAfter(text, "voxels needs "));
    if (text.find(" MiB of memory") != std::string::npos)
    {
      needs.back() /= 1024.0;
    }
    const double enough = NumberAfter(text, "so does --memory ") / 1024.0;
    EXPECT_NEAR(needs.back(), enough, 0.06) << text;
  }
  EXPECT_LT(needs[1], needs[0]); // none of these sees more than a part of the grid
}

TEST(MemoryNeed, HeadersAndTheSiteTableTellWhereRadarsStand)
{
  const FilesByRadar radars = {{"KTLX", {}}, {"KLSX", {}}};
  ASSERT_EQ(KnownPlaces(radars).size(), 2U);
  EXPECT_NEAR(KnownPlaces(radars)[0].latitude, 38.7, 0.01);
  EXPECT_TRUE(KnownPlaces(FilesByRadar{{"KTLX", {}}, {"XXXX", {}}}).empty());
  EXPECT_TRUE(KnownPlaces(std::nullopt).empty());
}

TEST(MemoryNeed, CountsTheSumsOfTheThesis)
{
  MergeOptions options;
  options.method = MergeMethod::Thesis;
  EXPECT_EQ(Need(options).voxels, voxels * (2 * 5 + 2 + 16));
}

TEST(MemoryNeed, CountsWhatAMergerKeepsOfTheRadars)
{
  const Position radar = {38.7, -90.7, 200.0};
  GridRequest request;
  request.dimensions = {64, 48, 8};
  const GridSpecification grid = MakeGrid(request, {radar});
  EXPECT_EQ(GeometryBytes(grid, {radar, radar}), 2U * 64U * 48U * 8U);
  EXPECT_EQ(GeometryBytes(grid, {Position{-38.7, 90.0, 0.0}}), 0U); // sees nothing of it
  EXPECT_EQ(GeometryBytes(grid, {radar, radar}, 12), 2U * 64U * 12U * 8U);
}

// Formulas G10: voxels twice as wide have half as many cells; narrow ones count as those with most.
TEST(MemoryNeed, CountsTheMeansOfWideVoxels)
{
  const Position radar = {38.7, -90.7, 200.0};
  MergeOptions options;
  const auto means = [&](int columns)
  {
    options.grid.dimensions = {columns, columns, 8};
    const GridSpecification grid = MakeGrid(options.grid, {radar});
    return static_cast<double>(RequireMemory(options, twoFiles, 2, written, grid, {radar}).means);
  };
  const double wide = means(100);
  EXPECT_NEAR(means(200), 2.0 * wide, 0.01 * wide);
  EXPECT_EQ(means(1000), means(2000));
  options.beam.means = false;
  EXPECT_EQ(means(100), 0.0);
  options.beam.means = true;
  options.method = MergeMethod::Thesis;
  EXPECT_EQ(means(100), 0.0);
}

TEST(MemoryNeed, LargerAndMoreFilesNeedMore)
{
  const MergeOptions options;
  const auto rays = [&options](std::size_t radars, std::size_t files, std::size_t fileBytes,
                      unsigned threads) {
    return NeedOf(options, {8, 8, 8}, {radars, files, fileBytes}, threads, written).rays;
  };
  const std::size_t usual = rays(3, 100, 4'000'000, 2);
  EXPECT_GT(rays(3, 100, 8'000'000, 2), usual);
  EXPECT_GT(rays(6, 100, 4'000'000, 2), usual);
  EXPECT_GT(rays(3, 100, 4'000'000, 4), usual);
  EXPECT_LT(rays(3, 2, 4'000'000, 2), usual); // no more than there are
}

TEST(MemoryNeed, WhatDoesNotFitIsRefusedWithWhatWould)
{
  MergeOptions options;
  options.grid.dimensions = {2048, 2048, 512};
  EXPECT_EQ(Refusal(options), ""); // without a limit
  options.memoryLimit = {2 * gibibyte, "--memory"};
  const std::string text = Refusal(options);
  EXPECT_NE(text.find("a grid of 2048x2048x512 voxels needs 24."), std::string::npos) << text;
  EXPECT_NE(text.find("--memory allows 2.0 GiB"), std::string::npos) << text;

  const std::size_t dims = text.find("--dims ") + 7;
  const int fitting = std::stoi(text.substr(dims));
  const std::size_t memory = text.rfind("--memory ") + 9;
  const std::size_t mebibytes = std::stoul(text.substr(memory));
  EXPECT_NE(text.find("x" + std::to_string(fitting / 4)), std::string::npos) << text;

  MergeOptions smaller = options;
  smaller.grid.dimensions = {fitting, fitting, fitting / 4};
  EXPECT_EQ(Refusal(smaller), "");
  smaller.grid.dimensions = {fitting + 16, fitting + 16, fitting / 4 + 4};
  EXPECT_NE(Refusal(smaller), "");
  options.memoryLimit.bytes = mebibytes << 20;
  EXPECT_EQ(Refusal(options), "");
}

TEST(MemoryNeed, WhereTheMachineHasNoMoreNoOptionIsNamed)
{
  MergeOptions options;
  options.grid.dimensions = {4096, 4096, 512};
  options.memoryLimit = {16 * gibibyte, ""};
  const std::string text = Refusal(options);
  EXPECT_NE(text.find("there is 16.0 GiB; --dims "), std::string::npos) << text;
  EXPECT_EQ(text.find("--memory"), std::string::npos) << text;
}

TEST(MemoryNeed, TooLittleForTheRaysIsRefusedToo)
{
  MergeOptions options;
  options.memoryLimit = {1, "--memory"};
  EXPECT_NE(Refusal(options).find("the rays and the program need"), std::string::npos)
    << Refusal(options);
}

// The sizes of grids that no computer holds can be counted.
TEST(MemoryNeed, TheLargestGridIsRefusedToo)
{
  MergeOptions options;
  options.grid.dimensions = {999'999'999, 999'999'999, 999'999'999};
  options.memoryLimit = {gibibyte, "--memory"};
  EXPECT_NE(Refusal(options).find("--dims "), std::string::npos);
}

TEST(MemoryNeed, KeptRaysTakeWhatIsLeft)
{
  MergeOptions options;
  const MemoryNeed need = Need(options);
  EXPECT_EQ(MemoryForKeptRays(options, need), gibibyte); // without a limit
  options.memoryLimit.bytes = need.Total() + 1000;
  EXPECT_EQ(MemoryForKeptRays(options, need), 1000U);
  options.memoryLimit.bytes = 8 * gibibyte;
  EXPECT_EQ(MemoryForKeptRays(options, need), gibibyte);
}

TEST(MemoryNeed, TheFileInTheMiddleStandsForAll)
{
  const TemporaryFolder folder;
  std::vector<std::filesystem::path> paths;
  for (const int size : {10, 3'000, 20})
  {
    paths.push_back(folder.Path() / std::to_string(size));
    std::ofstream(paths.back()) << std::string(static_cast<std::size_t>(size), 'a');
  }
  paths.push_back(folder.Path()); // as a chunk folder
  const InputSizes sizes = SizesOf(paths, 2);
  EXPECT_EQ(sizes.fileBytes, 20U);
  EXPECT_EQ(sizes.files, 4U);
  EXPECT_EQ(sizes.radars, 2U);
}

TEST(MemoryNeed, MessagesInGzipCountAsInRecords)
{
  const TemporaryFolder folder;
  const auto bytesOf = [&folder](const Bytes& stored)
  { return SizesOf({WriteBytes(folder.Path() / "file", stored)}, 1).fileBytes; };
  const Bytes bare = Gzip(MakeSmallVolume(31));
  EXPECT_EQ(bytesOf(bare), static_cast<std::size_t>(static_cast<double>(bare.size()) / 1.2));
  Bytes records = MakeVolumeHeader();
  const Bytes record = MakeLdmRecord(MakeMessage31(RayPlan()), true);
  records.insert(records.end(), record.begin(), record.end());
  EXPECT_EQ(bytesOf(records), records.size());
  EXPECT_EQ(bytesOf(Gzip(records)), Gzip(records).size());
  EXPECT_EQ(bytesOf(MakeSmallVolume(31)), MakeSmallVolume(31).size());
  const Bytes other = Gzip(Bytes(100, 'a'));
  EXPECT_EQ(bytesOf(other), other.size());
}

// Nothing of the file is read but its size: it is no radar file.
TEST(MemoryNeed, AMergerRefusesBeforeItDecodes)
{
  const TemporaryFolder folder;
  std::ofstream(folder.Path() / "file") << "no radar file";
  MergeOptions options;
  options.grid.dimensions = {1024, 1024, 256};
  options.memoryLimit = {gibibyte, "--memory"};
  SeriesMerger merger({folder.Path() / "file"}, options);
  const std::string error = MessageOf([&] { merger.Open(); });
  EXPECT_NE(error.find("1024x1024x256"), std::string::npos) << error;
}

// SPDX-License-Identifier: BSD-3-Clause
#include "nexrad/Codec/NxvFile.h"
#include "nexrad/Grid/MakeGrid.h"

#include "ErrorMessage.h"
#include "TestData.h"
#include "VolumeMaker.h"
#include "nexrad/Codec/ThesisStream.h"
#include "nexrad/System/Error.h"
#include "nexrad/System/RangeLoop.h"

#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <random>

using namespace nexrad;
using nexrad::testing::AddAncillary;
using nexrad::testing::FileContent;
using nexrad::testing::MakeGriddedVolume;
using nexrad::testing::MessageOf;
using nexrad::testing::TemporaryFolder;

namespace
{

namespace fs = std::filesystem;

GriddedVolume RoundTrip(const GriddedVolume& volume, std::optional<NxvEncoding> encoding)
{
  const TemporaryFolder folder;
  WriteNxv(folder.Path() / "a.nxv", volume, encoding);
  return ReadNxv(folder.Path() / "a.nxv");
}

// What a volume is after it went through the thesis's codes.
GriddedVolume Quantized(const GriddedVolume& volume)
{
  GriddedVolume rounded = volume;
  const std::vector<std::uint8_t> codes = ThesisCode::EncodeAll(volume);
  for (std::size_t i = 0; i < codes.size(); ++i)
  {
    rounded.states[i] = ThesisCode::StateOf(codes[i]);
    rounded.values[i] =
      rounded.states[i] == VoxelState::Echo ? static_cast<float>(codes[i]) : volume.fill;
  }
  return rounded;
}

void ExpectSameVoxels(const GriddedVolume& actual, const GriddedVolume& expected)
{
  EXPECT_EQ(actual.values, expected.values);
  EXPECT_EQ(actual.states, expected.states);
}

} // namespace

TEST(NxvFile, TheHeaderComesBack)
{
  GriddedVolume volume = MakeGriddedVolume();
  volume.synthetic = true;
  const TemporaryFolder folder;
  WriteNxv(folder.Path() / "a.nxv", volume);
  for (const bool headerOnly : {true, false})
  {
    const fs::path path = folder.Path() / "a.nxv";
    const GriddedVolume read = headerOnly ? ReadNxvHeader(path) : ReadNxv(path);
    EXPECT_EQ(read.grid.dimensions, volume.grid.dimensions);
    EXPECT_EQ(read.grid.origin, volume.grid.origin);
    EXPECT_EQ(read.grid.spacing, volume.grid.spacing);
    EXPECT_EQ(read.grid.axes, GridAxes::Projected);
    EXPECT_EQ(read.grid.centreLatitude, 39.21);
    EXPECT_EQ(read.grid.centreLongitude, -91.7);
    EXPECT_EQ(read.time, volume.time);
    EXPECT_EQ(read.moment, MomentName::REF);
    EXPECT_EQ(read.method, "beam");
    EXPECT_EQ(read.sites, volume.sites);
    EXPECT_TRUE(read.synthetic);
    EXPECT_EQ(read.fill, -33.0F);
    EXPECT_EQ(read.values.empty(), headerOnly);
  }
}

// Made as every writer may make it, byte for byte: 2 × 1 × 1 voxels, one not scanned, one 40 dBZ.
// The payload is FF A8, its CRC-32 0AF0C457 by an independent program (Python's zlib).
TEST(NxvFile, ReadsAFileMadeByHand)
{
  const std::string header =
    R"({"dimensions":[2,1,1],"origin":[0,0,500],"spacing":[1000,1000,1000],)"
    R"("projection":"+proj=aeqd +lat_0=39.2 +lon_0=-91.5 +datum=WGS84 +units=m +no_defs",)"
    R"("time":"2006-03-12T18:00:00Z","sites":["KEAX"],"method":"thesis","arrays":[{"name":"REF",)"
    R"("type":"uint7","unit":"dBZ","offset":0,"scale":1,"fill":0,"encoding":"rle","length":2,)"
    R"("crc32":@CRC@}]})";
  const TemporaryFolder folder;
  const auto write = [&](const std::string& text)
  {
    std::ofstream file(folder.Path() / "hand.nxv", std::ios::binary);
    file << "NXV1" << static_cast<char>(text.size() & 0xFF) << static_cast<char>(text.size() >> 8)
         << '\0' << '\0' << text << "\xFF\xA8";
  };
  const auto withCrc = [&](const std::string& crc)
  { return std::string(header).replace(header.find("@CRC@"), 5, crc); };
  write(withCrc("183551063"));
  const GriddedVolume volume = ReadNxv(folder.Path() / "hand.nxv");
  EXPECT_EQ(volume.states, (std::vector<VoxelState>{VoxelState::NotScanned, VoxelState::Echo}));
  EXPECT_EQ(volume.values, (std::vector<float>{0.0F, 40.0F}));
  EXPECT_EQ(volume.grid.centreLatitude, 39.2);
  EXPECT_FALSE(volume.synthetic);
  write(withCrc("1"));
  EXPECT_THROW(ReadNxv(folder.Path() / "hand.nxv"), Error);
}

TEST(NxvFile, CodesRoundTripToTheWholeDecibel)
{
  const GriddedVolume volume = MakeGriddedVolume();
  ExpectSameVoxels(RoundTrip(volume, NxvEncoding::Thesis), Quantized(volume));
}

TEST(NxvFile, FloatsAndStatesAreExact)
{
  GriddedVolume volume = MakeGriddedVolume();
  volume.states[0] = VoxelState::RangeFolded;
  volume.values[0] = volume.fill;
  ExpectSameVoxels(RoundTrip(volume, NxvEncoding::Float), volume);
}

// Snow and clear air are weaker than 0 dBZ. The codes of whole dBZ made them no echo.
TEST(NxvFile, WeakEchoesSurviveByDefault)
{
  GriddedVolume volume = MakeGriddedVolume({508, 1, 1}); // to 94.5 dBZ
  for (std::size_t i = 0; i < volume.values.size(); ++i)
  {
    volume.states[i] = i % 2 == 0 ? VoxelState::Echo : VoxelState::NotScanned;
    volume.values[i] = i % 2 == 0 ? 0.25F * static_cast<float>(i) - 32.0F : volume.fill;
  }
  const GriddedVolume read = RoundTrip(volume, {});
  EXPECT_EQ(read.states, volume.states);
  for (std::size_t i = 0; i < volume.values.size(); i += 2)
  {
    EXPECT_NEAR(read.values[i], volume.values[i], 0.25F);
  }
  EXPECT_EQ(RoundTrip(read, {}).values, read.values);
}

TEST(NxvFile, OtherMomentsKeepTheStepsOfTheRadarByDefault)
{
  GriddedVolume volume = MakeGriddedVolume();
  volume.moment = MomentName::VEL;
  volume.states[0] = volume.states[3] = VoxelState::Echo;
  for (const float fastest : {21.5F, 100.0F}) // in one byte, and in two
  {
    volume.values[0] = -fastest;
    const GriddedVolume read = RoundTrip(volume, {});
    EXPECT_EQ(read.moment, MomentName::VEL);
    EXPECT_EQ(read.values[0], -fastest);
    EXPECT_EQ(read.states, volume.states);
    EXPECT_NEAR(read.values[3], volume.values[3], 0.25F);
  }
}

TEST(NxvFile, RangeFoldedSurvivesTheCodes)
{
  GriddedVolume volume = MakeGriddedVolume();
  volume.states[1] = VoxelState::RangeFolded;
  volume.states[3] = VoxelState::Echo;
  volume.values[3] = -12.0F; // becomes no echo, with the array of states as without
  GriddedVolume expected = Quantized(volume);
  expected.states[1] = VoxelState::RangeFolded;
  EXPECT_EQ(expected.states[3], VoxelState::NoEcho);
  ExpectSameVoxels(RoundTrip(volume, NxvEncoding::Thesis), expected);
  expected.states[3] = VoxelState::Echo;
  expected.values[3] = -12.0F;
  const GriddedVolume steps = RoundTrip(volume, {});
  EXPECT_EQ(steps.states, expected.states);
  EXPECT_EQ(steps.values[1], volume.fill);
  EXPECT_EQ(steps.values[3], -12.0F);
}

TEST(NxvFile, EmptyFullAndRandomVolumesRoundTrip)
{
  std::mt19937 random(11);
  for (const auto& dimensions : {std::array<int, 3>{1, 1, 1}, {40, 30, 20}})
  {
    for (const int kind : {0, 1, 2, 3})
    {
      GriddedVolume volume = MakeGriddedVolume(dimensions);
      for (std::size_t i = 0; i < volume.values.size(); ++i)
      {
        volume.states[i] = static_cast<VoxelState>(kind == 2 ? random() % 4 : kind);
        volume.values[i] = volume.states[i] == VoxelState::Echo
                             ? static_cast<float>(1 + random() % 80)
                             : volume.fill;
      }
      for (const auto encoding : {NxvEncoding::RadarSteps, NxvEncoding::Thesis, NxvEncoding::Float})
      {
        ExpectSameVoxels(RoundTrip(volume, encoding), volume);
      }
    }
  }
}

TEST(NxvFile, AncillaryArraysComeBack)
{
  GriddedVolume volume = MakeGriddedVolume({40, 30, 20});
  AddAncillary(volume);
  for (const auto encoding : {NxvEncoding::RadarSteps, NxvEncoding::Thesis, NxvEncoding::Float})
  {
    const GriddedVolume read = RoundTrip(volume, encoding);
    EXPECT_EQ(read.ancillary.radars, volume.ancillary.radars);
    EXPECT_EQ(read.ancillary.nearestSite, volume.ancillary.nearestSite);
    if (encoding == NxvEncoding::Float)
    {
      EXPECT_EQ(read.ancillary.age, volume.ancillary.age);
      EXPECT_EQ(read.ancillary.weight, volume.ancillary.weight);
      continue;
    }
    // The ages reach to 186,473 s: 255 steps of 1000 s. The weights reach to 1: of 0.01.
    for (std::size_t i = 0; i < volume.values.size(); ++i)
    {
      ASSERT_NEAR(read.ancillary.age[i], volume.ancillary.age[i], 500.01F) << i;
      ASSERT_NEAR(read.ancillary.weight[i], volume.ancillary.weight[i], 0.00501F) << i;
    }
    EXPECT_NE(read.ancillary.age, volume.ancillary.age);
    // What was rounded once stays as it is.
    const GriddedVolume again = RoundTrip(read, encoding);
    EXPECT_EQ(again.ancillary.age, read.ancillary.age);
    EXPECT_EQ(again.ancillary.weight, read.ancillary.weight);
  }
}

// The steps of the codes, by the largest value.
TEST(NxvFile, StepsOfAncillaryArraysAreAsFineAsTheLargestValueAllows)
{
  const std::vector<std::pair<float, double>> cases = {{0.0F, 1.0}, {255.0F, 1.0}, {256.0F, 2.0},
    {511.0F, 5.0}, {900.0F, 5.0}, {1276.0F, 10.0}, {2700.0F, 20.0}};
  for (const auto& [largest, step] : cases)
  {
    GriddedVolume volume = MakeGriddedVolume({4, 1, 1});
    volume.ancillary.age = {largest, 0.0F, largest / 2.0F, largest / 3.0F};
    const std::vector<float> read = RoundTrip(volume, {}).ancillary.age;
    for (std::size_t i = 0; i < read.size(); ++i)
    {
      EXPECT_NEAR(read[i], volume.ancillary.age[i], 0.5 * step) << largest;
      EXPECT_EQ(std::remainder(static_cast<double>(read[i]), step), 0.0) << largest;
    }
    EXPECT_EQ(read[1], 0.0F);
  }
}

TEST(NxvFile, AncillaryArraysCanBeLeftOutAndSomeBeMissing)
{
  GriddedVolume volume = MakeGriddedVolume();
  AddAncillary(volume);
  volume.ancillary.weight.clear();
  const TemporaryFolder folder;
  const fs::path path = folder.Path() / "a.nxv";
  WriteNxv(path, volume);
  EXPECT_EQ(ReadNxvAncillaryArrayNames(path),
    (std::vector<std::string>{"REF_age", "REF_radars", "REF_site"}));
  NxvReadOptions options;
  options.leaveOut = {"REF_age", "REF_site"};
  const GriddedVolume read = ReadNxv(path, options);
  EXPECT_TRUE(read.ancillary.age.empty());
  EXPECT_TRUE(read.ancillary.weight.empty());
  EXPECT_TRUE(read.ancillary.nearestSite.empty());
  EXPECT_EQ(read.ancillary.radars, volume.ancillary.radars);
  // Memory counts for what is read alone: 60 voxels of six bytes, and one more each.
  options.maximumBytes = 60 * 7;
  EXPECT_EQ(ReadNxv(path, options).values.size(), 60u);
  options.maximumBytes = 60 * 7 - 1;
  EXPECT_THROW(ReadNxv(path, options), Error);
  // A volume without any has none in its file.
  WriteNxv(path, MakeGriddedVolume());
  EXPECT_TRUE(ReadNxvAncillaryArrayNames(path).empty());
  volume.ancillary.age[3] = -1.0F;
  EXPECT_THROW(WriteNxv(path, volume), Error);
  volume.ancillary.age.pop_back();
  EXPECT_THROW(WriteNxv(path, volume), Error);
}

namespace
{

// 1 310 720 voxels, more than a piece of a payload holds, some of each state.
GriddedVolume MakeLargeVolume()
{
  GriddedVolume volume = MakeGriddedVolume({128, 128, 80});
  std::mt19937 random(7);
  for (std::size_t i = 0; i < volume.values.size(); ++i)
  {
    const bool echo = random() % 4 == 0;
    volume.states[i] = echo                ? VoxelState::Echo
                       : i / 1000 % 3 == 0 ? VoxelState::NotScanned
                                           : VoxelState::NoEcho;
    volume.values[i] = echo ? static_cast<float>(1 + random() % 80) : volume.fill;
  }
  return volume;
}

} // namespace

// A reader that decompresses several pieces at a time, and one that takes the payload for a single
// stream, as readers of other programs do.
TEST(NxvFile, LargeArraysHavePiecesThatAnyReaderCanPassOver)
{
  const TemporaryFolder folder;
  const fs::path path = folder.Path() / "a.nxv";
  const GriddedVolume volume = MakeLargeVolume();
  for (const auto encoding : {NxvEncoding::RadarSteps, NxvEncoding::Thesis, NxvEncoding::Float})
  {
    WriteNxv(path, volume, encoding);
    const std::string content = FileContent(path);
    EXPECT_EQ(content.find("\"pieces\":[") == std::string::npos, encoding == NxvEncoding::Thesis);
    ExpectSameVoxels(ReadNxv(path), volume);
    NxvReadOptions options;
    options.loop = ThreadLoop(3);
    ExpectSameVoxels(ReadNxv(path, options), volume);
    // The key by another name is as good as none, and the header's checksum may be left out.
    std::string older = content;
    for (std::size_t at = 0; (at = older.find("\"pieces\"", at)) != std::string::npos;)
    {
      older.replace(at, 8, "\"Pieces\"");
    }
    older.replace(older.find("\"header_crc32\""), 14, "\"Header_crc32\"");
    std::ofstream(path, std::ios::binary) << older;
    ExpectSameVoxels(ReadNxv(path), volume);
  }
}

// A volume of one piece has the file that it always had.
TEST(NxvFile, SmallArraysHaveNoPieces)
{
  const TemporaryFolder folder;
  WriteNxv(folder.Path() / "a.nxv", MakeGriddedVolume({128, 128, 64}));
  EXPECT_EQ(FileContent(folder.Path() / "a.nxv").find("piece"), std::string::npos);
}

TEST(NxvFile, CodesAreReadAsTheyAre)
{
  const TemporaryFolder folder;
  const fs::path path = folder.Path() / "a.nxv";
  const GriddedVolume volume = MakeLargeVolume();
  for (const auto encoding : {NxvEncoding::RadarSteps, NxvEncoding::Thesis})
  {
    WriteNxv(path, volume, encoding);
    EXPECT_TRUE(HasNxvCodes(path));
    const auto coded = ReadNxvCodes(path, {}, true);
    ASSERT_TRUE(coded);
    EXPECT_EQ(coded->volume.grid, volume.grid);
    GriddedVolume expanded = coded->volume;
    expanded.values.resize(volume.values.size());
    expanded.states.resize(volume.values.size());
    ExpandCodes(coded->meaning, coded->codes.get(), volume.values.size(), expanded.values.data(),
      expanded.states.data(), ThreadLoop(2));
    ExpectSameVoxels(expanded, volume);
  }
  WriteNxv(path, volume, NxvEncoding::Float);
  EXPECT_FALSE(HasNxvCodes(path));
  EXPECT_FALSE(ReadNxvCodes(path));
}

// The codes say no echo there, and the reader says that they do not say all.
TEST(NxvFile, CodesTellWhenVoxelsAreRangeFolded)
{
  const TemporaryFolder folder;
  const fs::path path = folder.Path() / "a.nxv";
  GriddedVolume volume = MakeGriddedVolume({4, 3, 2});
  volume.states[5] = VoxelState::RangeFolded;
  WriteNxv(path, volume);
  const auto coded = ReadNxvCodes(path);
  ASSERT_TRUE(coded);
  EXPECT_EQ(coded->meaning.states[coded->codes[5]], VoxelState::NoEcho);
  EXPECT_TRUE(HasNxvCodes(path));
  EXPECT_FALSE(ReadNxvCodes(path, {}, true));
}

// In an array of their own, which versions that do not know it pass over: `_state` has no state
// that they would refuse.
TEST(NxvFile, FilteredVoxelsComeBackInAllEncodings)
{
  const TemporaryFolder folder;
  const fs::path path = folder.Path() / "a.nxv";
  for (const bool folded : {false, true})
  {
    GriddedVolume volume = MakeGriddedVolume({4, 3, 2});
    for (const std::size_t voxel : {5, 7})
    {
      volume.states[voxel] = VoxelState::Filtered;
      volume.values[voxel] = volume.fill;
    }
    if (folded)
    {
      volume.states[6] = VoxelState::RangeFolded;
      volume.values[6] = volume.fill;
    }
    for (const auto encoding : {NxvEncoding::RadarSteps, NxvEncoding::Thesis, NxvEncoding::Float})
    {
      WriteNxv(path, volume, encoding);
      const GriddedVolume read = ReadNxv(path);
      EXPECT_EQ(read.states[5], VoxelState::Filtered);
      EXPECT_EQ(read.states[7], VoxelState::Filtered);
      EXPECT_EQ(read.states[6], folded ? VoxelState::RangeFolded : volume.states[6]);
      EXPECT_EQ(read.values[5], volume.fill);
      const bool states = FileContent(path).find("REF_state") != std::string::npos;
      EXPECT_EQ(states, folded || encoding == NxvEncoding::Float);
      EXPECT_FALSE(ReadNxvCodes(path, {}, true));
    }
  }
}

TEST(NxvFile, TheThesisWritesRunsOfTwo)
{
  GriddedVolume volume = MakeGriddedVolume({3, 1, 1});
  volume.states.assign(3, VoxelState::Echo);
  volume.values = {30.0F, 30.0F, 40.0F};
  const TemporaryFolder folder;
  volume.method = "thesis";
  WriteNxv(folder.Path() / "a.nxv", volume);
  const std::string whole = FileContent(folder.Path() / "a.nxv");
  EXPECT_EQ(whole.substr(whole.size() - 6), std::string("\x1E\2\0\0\0\xA8", 6));
}

TEST(NxvFile, GeographicAxesComeBack)
{
  GridRequest request;
  request.axes = GridAxes::Geographic;
  request.bounds = GeographicBounds{-96.0, 36.0, -88.0, 42.0};
  request.dimensions = {3, 4, 5};
  GriddedVolume volume = MakeGriddedVolume({3, 4, 5});
  volume.grid = MakeGrid(request, {});
  const GriddedVolume read = RoundTrip(volume, {});
  EXPECT_EQ(read.grid.axes, GridAxes::Geographic);
  EXPECT_EQ(read.grid.origin, volume.grid.origin);
  EXPECT_EQ(read.grid.centreLatitude, volume.grid.centreLatitude);
  EXPECT_EQ(read.grid.centreLongitude, volume.grid.centreLongitude);
}

TEST(NxvSeries, ComesBackInOrder)
{
  const TemporaryFolder folder;
  const NxvSeries series = {
    {"20060312T180000Z.nxv", 1142186400.0}, {"20060312T180500Z.nxv", 1142186700.25}};
  WriteNxvSeries(folder.Path() / "day.nxv.series", series);
  EXPECT_EQ(ReadNxvSeries(folder.Path() / "day.nxv.series"), series);
}

TEST(NxvSeries, RefusesWhatIsNone)
{
  const TemporaryFolder folder;
  const fs::path path = folder.Path() / "bad.nxv.series";
  for (const char* text : {"", "[]", "{}", "{\"file-series-version\":\"1.0\"}",
         "{\"file-series-version\":\"2.0\",\"files\":[]}",
         "{\"file-series-version\":\"1.0\",\"files\":[{\"name\":1,\"time\":2}]}",
         "{\"file-series-version\":\"1.0\",\"files\":[{\"name\":\"a\"}]}",
         "{\"file-series-version\":\"1.0\",\"files\":7}",
         // Such times have no milliseconds in 64 bits, and no year that can be written.
         "{\"file-series-version\":\"1.0\",\"files\":[{\"name\":\"a\",\"time\":1e300}]}",
         "{\"file-series-version\":\"1.0\",\"files\":[{\"name\":\"a\",\"time\":-1e12}]}"})
  {
    std::ofstream(path) << text;
    EXPECT_THROW(ReadNxvSeries(path), Error) << text;
  }
  EXPECT_THROW(ReadNxvSeries(folder.Path() / "none"), Error);
  EXPECT_THROW(ReadNxvSeries(folder.Path()), Error);
}

// The parser's message repeated all that it had read.
TEST(NxvSeries, MessagesAreShort)
{
  const TemporaryFolder folder;
  const fs::path path = folder.Path() / "bad.nxv.series";
  std::ofstream(path) << "{" << std::string(2000, '\n') << "x";
  const std::string line = MessageOf([&] { ReadNxvSeries(path); });
  EXPECT_LT(line.size(), path.string().size() + 400) << line;
  EXPECT_NE(line.find("not a series index"), std::string::npos) << line;
}

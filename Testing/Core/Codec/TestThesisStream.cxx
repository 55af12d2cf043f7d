// SPDX-License-Identifier: BSD-3-Clause
#include "nexrad/Codec/ThesisStream.h"

#include "ErrorMessage.h"
#include "VolumeMaker.h"
#include "nexrad/System/Error.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <vector>

using namespace nexrad;
using nexrad::testing::MessageOf;

namespace
{

using Bytes = std::vector<std::uint8_t>;

Bytes Decode(const Bytes& stream, std::size_t count)
{
  Bytes codes(count);
  DecodeRunLength(stream.data(), stream.size(), codes.data(), count);
  return codes;
}

std::string ErrorOf(const Bytes& stream, std::size_t count)
{
  return MessageOf([&] { Decode(stream, count); });
}

// The code of a voxel.
int CodeOf(float value, VoxelState state)
{
  GriddedVolume volume = nexrad::testing::MakeGriddedVolume({1, 1, 1});
  volume.values = {value};
  volume.states = {state};
  return ThesisCode::EncodeAll(volume).front();
}

} // namespace

// A volume of 4 × 2 × 2 voxels worked out by hand from T8:
//   127 127 127 127 | 0 0 0 35 | 35 36 0 0 | 0 0 80 0
// run of four 127:   7F  04 00 00 00
// run of three 0:    00  03 00 00 00
// run of two 35 (it crosses the row and the layer): 23  02 00 00 00
// literal 36:        80 | 24 = A4
// run of four 0 (crossing a row): 00  04 00 00 00
// literal 80:        80 | 50 = D0
// literal 0:         80 | 00 = 80
TEST(RunLengthT8, TheThesisStreamByteForByte)
{
  const Bytes codes = {127, 127, 127, 127, 0, 0, 0, 35, 35, 36, 0, 0, 0, 0, 80, 0};
  const Bytes stream = {
    0x7F, 4, 0, 0, 0, 0x00, 3, 0, 0, 0, 0x23, 2, 0, 0, 0, 0xA4, 0x00, 4, 0, 0, 0, 0xD0, 0x80};
  EXPECT_EQ(EncodeRunLength(codes), stream);
  EXPECT_EQ(Decode(stream, codes.size()), codes);
}

// 70 000 = 0x00011170: every byte of the length counts, least significant first.
TEST(RunLengthT8, LengthsAreLittleEndian)
{
  EXPECT_EQ(EncodeRunLength(Bytes(70'000, 1)), (Bytes{0x01, 0x70, 0x11, 0x01, 0x00}));
  EXPECT_EQ(Decode({0x01, 0x70, 0x11, 0x01, 0x00}, 70'000), Bytes(70'000, 1));
}

TEST(RunLengthT8, RoundTripsRandomEmptyFullAndSingle)
{
  std::mt19937 random(7);
  std::vector<Bytes> volumes = {{}, {0}, {127}, Bytes(4096, 0), Bytes(4096, 127)};
  for (const unsigned kinds : {2u, 5u, 128u})
  {
    Bytes codes(10'000);
    for (std::uint8_t& code : codes)
    {
      code = static_cast<std::uint8_t>(random() % kinds);
    }
    volumes.push_back(codes);
  }
  for (const Bytes& codes : volumes)
  {
    EXPECT_EQ(Decode(EncodeRunLength(codes), codes.size()), codes);
  }
}

TEST(RunLengthT8, DamageIsNamedWithItsOffset)
{
  EXPECT_EQ(ErrorOf({0x81, 0x05, 0, 0, 0, 0}, 4),
    "byte 1 of the run-length stream: a run of no voxels; its length must be 1 or more");
  EXPECT_EQ(ErrorOf({0x81, 0x05, 4, 0, 0, 0}, 4),
    "byte 1 of the run-length stream: a run of 4 where 3 voxels are left");
  EXPECT_EQ(ErrorOf({0x05, 0xFF, 0xFF, 0xFF, 0xFF}, 4),
    "byte 0 of the run-length stream: a run of 4294967295 where 4 voxels are left");
  EXPECT_EQ(
    ErrorOf({0x05, 4, 0, 0}, 4), "byte 4 of the run-length stream: the stream ends within a run");
  EXPECT_EQ(ErrorOf({0x05, 3, 0, 0, 0}, 4),
    "byte 5 of the run-length stream: the stream ends after 3 of 4 voxels");
  EXPECT_EQ(ErrorOf({0x05, 4, 0, 0, 0, 0x81}, 4),
    "byte 5 of the run-length stream: more bytes after the last of 4 voxels");
  EXPECT_NE(ErrorOf({0x81}, 0), "");
  EXPECT_EQ(ErrorOf({}, 0), "");
}

TEST(RunLengthT8, RefusesCodesOfEightBits)
{
  EXPECT_THROW(EncodeRunLength({1, 128}), Error);
}

// A stream long enough to be decoded in parts: runs and literals of every length about the parts'
// ends, by one thread and by three. Readers take runs of one and literals that a run would hold.
TEST(RunLengthT8, PartsGiveTheCodesOfTheWhole)
{
  std::mt19937 random(5);
  Bytes codes;
  while (codes.size() < 3'000'000)
  {
    const unsigned choice = random() % 100;
    const std::size_t length = choice == 0 ? random() % 300'000 : choice < 30 ? random() % 40 : 1;
    codes.insert(codes.end(), length, static_cast<std::uint8_t>(random() % 128));
  }
  const Bytes stream = EncodeRunLength(codes);
  for (const unsigned threads : {1U, 3U})
  {
    Bytes decoded(codes.size());
    DecodeRunLength(
      stream.data(), stream.size(), decoded.data(), decoded.size(), ThreadLoop(threads));
    EXPECT_TRUE(decoded == codes) << threads;
  }
  EXPECT_NE(ErrorOf(stream, codes.size() - 1), "");
  EXPECT_NE(ErrorOf(stream, codes.size() + 1), "");
}

TEST(ThesisCode, IsTheWholeDecibel)
{
  const auto code = [](float value) { return CodeOf(value, VoxelState::Echo); };
  EXPECT_EQ(code(35.0F), 35);
  EXPECT_EQ(code(35.49F), 35);
  EXPECT_EQ(code(35.5F), 36);
  EXPECT_EQ(code(80.0F), 80);
  EXPECT_EQ(code(94.5F), 80) << "0 to 80 dBZ";
  EXPECT_EQ(code(0.4F), 0);
  EXPECT_EQ(code(-20.0F), 0) << "an echo at or below 0 dBZ is no echo";
}

TEST(ThesisCode, StatesHaveCodes)
{
  EXPECT_EQ(CodeOf(50.0F, VoxelState::NoEcho), 0);
  EXPECT_EQ(CodeOf(50.0F, VoxelState::RangeFolded), 0);
  EXPECT_EQ(CodeOf(50.0F, VoxelState::NotScanned), 127);
  EXPECT_EQ(ThesisCode::StateOf(0), VoxelState::NoEcho);
  EXPECT_EQ(ThesisCode::StateOf(1), VoxelState::Echo);
  EXPECT_EQ(ThesisCode::StateOf(80), VoxelState::Echo);
  EXPECT_EQ(ThesisCode::StateOf(127), VoxelState::NotScanned);
}

TEST(ThesisCode, NumbersThatAreNoneDoNoHarm)
{
  constexpr float infinity = std::numeric_limits<float>::infinity();
  EXPECT_EQ(CodeOf(std::nanf(""), VoxelState::Echo), 127);
  EXPECT_EQ(CodeOf(infinity, VoxelState::Echo), 80);
  EXPECT_EQ(CodeOf(-infinity, VoxelState::Echo), 0);
}

TEST(ThesisCode, RefusesWhatCannotBeUsed)
{
  const GriddedVolume volume = nexrad::testing::MakeGriddedVolume();
  GriddedVolume shorter = volume;
  shorter.states.pop_back();
  EXPECT_THROW(ThesisCode::EncodeAll(shorter), Error);
}

TEST(ThesisCode, AllVoxelsAreRoundedAsEachIs)
{
  GriddedVolume volume = nexrad::testing::MakeGriddedVolume();
  volume.grid.dimensions = {97, 11, 3};
  volume.values.clear();
  volume.states.clear();
  std::mt19937 random(11);
  Bytes expected;
  while (expected.size() < volume.grid.VoxelCount())
  {
    // Sixteenths, so that halves are met exactly.
    const float value = static_cast<float>(random() % 1'600) / 16.0F - 5.0F;
    const auto state = static_cast<VoxelState>(random() % 4);
    volume.values.push_back(value);
    volume.states.push_back(state);
    const float rounded = std::clamp(std::round(value), 0.0F, 80.0F);
    expected.push_back(state == VoxelState::Echo         ? static_cast<std::uint8_t>(rounded)
                       : state == VoxelState::NotScanned ? ThesisCode::NotScannedCode
                                                         : ThesisCode::NoEchoCode);
  }
  EXPECT_EQ(ThesisCode::EncodeAll(volume), expected);
}

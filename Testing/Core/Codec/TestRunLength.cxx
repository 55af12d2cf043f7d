// SPDX-License-Identifier: BSD-3-Clause
#include "nexrad/Codec/RunLength.h"

#include "nexrad/System/Error.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

using namespace nexrad;

namespace
{

using Bytes = std::vector<std::uint8_t>;

Bytes Encode(const Bytes& codes, RunLengthThreshold threshold = RunLengthThreshold::Thesis)
{
  return EncodeRunLength(codes.data(), codes.size(), threshold);
}

Bytes Decode(const Bytes& stream, std::size_t count)
{
  Bytes codes(count);
  DecodeRunLength(stream.data(), stream.size(), codes.data(), count);
  return codes;
}

std::string ErrorOf(const Bytes& stream, std::size_t count)
{
  try
  {
    Decode(stream, count);
  }
  catch (const Error& problem)
  {
    return problem.what();
  }
  return "";
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
  EXPECT_EQ(Encode(codes), stream);
  EXPECT_EQ(Decode(stream, codes.size()), codes);
}

// The same volume when a run must be six long: no run is, sixteen literals.
TEST(RunLengthT8, ShortRunsAreLiteralsByDefault)
{
  const Bytes codes = {127, 127, 127, 127, 0, 0, 0, 35, 35, 36, 0, 0, 0, 0, 80, 0};
  const Bytes stream = {
    0xFF, 0xFF, 0xFF, 0xFF, 0x80, 0x80, 0x80, 0xA3, 0xA3, 0xA4, 0x80, 0x80, 0x80, 0x80, 0xD0, 0x80};
  EXPECT_EQ(Encode(codes, RunLengthThreshold::Compact), stream);
  EXPECT_EQ(Decode(stream, codes.size()), codes);
  EXPECT_EQ(Encode(Bytes(5, 9), RunLengthThreshold::Compact), Bytes(5, 0x89));
  EXPECT_EQ(Encode(Bytes(6, 9), RunLengthThreshold::Compact), (Bytes{9, 6, 0, 0, 0}));
}

// 70 000 = 0x00011170: every byte of the length counts, least significant first.
TEST(RunLengthT8, LengthsAreLittleEndian)
{
  EXPECT_EQ(Encode(Bytes(70'000, 1)), (Bytes{0x01, 0x70, 0x11, 0x01, 0x00}));
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
    for (const auto threshold : {RunLengthThreshold::Thesis, RunLengthThreshold::Compact})
    {
      EXPECT_EQ(Decode(Encode(codes, threshold), codes.size()), codes);
    }
    EXPECT_LE(Encode(codes, RunLengthThreshold::Compact).size(), codes.size() + 4);
  }
}

TEST(RunLengthT8, APieceAtATimeIsTheSame)
{
  const Bytes codes = {5, 5, 5, 5, 5, 5, 5, 9, 9, 1};
  const Bytes stream = Encode(codes);
  Bytes decoded(codes.size());
  RunLengthDecoder decoder(decoded.data(), decoded.size());
  for (const std::uint8_t byte : stream)
  {
    decoder.Feed(&byte, 1);
  }
  decoder.Finish();
  EXPECT_EQ(decoded, codes);
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
  EXPECT_THROW(Encode({1, 128}), Error);
}

TEST(RunLengthT8, PiecesGiveTheStreamOfTheWhole)
{
  std::mt19937 random(3);
  Bytes codes;
  while (codes.size() < 20'000)
  {
    codes.insert(codes.end(), 1 + random() % 40, static_cast<std::uint8_t>(random() % 128));
  }
  for (const auto threshold : {RunLengthThreshold::Thesis, RunLengthThreshold::Compact})
  {
    RunLengthEncoder encoder(threshold);
    for (std::size_t begin = 0; begin < codes.size();)
    {
      const std::size_t size = std::min<std::size_t>(random() % 50, codes.size() - begin);
      encoder.Feed(codes.data() + begin, size);
      begin += size;
    }
    const Bytes stream = encoder.Finish();
    EXPECT_EQ(stream, Encode(codes, threshold));
    EXPECT_EQ(Decode(stream, codes.size()), codes);
  }
}

// A stream long enough to be decoded in parts: runs and literals of every length about the parts'
// ends, by one thread and by three, beside the decoder that takes byte after byte.
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
  const Bytes stream = Encode(codes);
  Bytes expected(codes.size());
  RunLengthDecoder decoder(expected.data(), expected.size());
  decoder.Feed(stream.data(), stream.size());
  decoder.Finish();
  EXPECT_TRUE(expected == codes);
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

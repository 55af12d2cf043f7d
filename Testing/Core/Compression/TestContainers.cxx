// SPDX-License-Identifier: BSD-3-Clause
#include "nexrad/Compression/Container.h"
#include "nexrad/Compression/LdmRecords.h"
#include "nexrad/Compression/Unlzw.h"

#include "Faults/HostileFiles.h"
#include "Level2Bytes.h"
#include "TestData.h"
#include "Tolerance.h"

#include <gtest/gtest.h>
#include <zlib.h>

#include <fstream>
#include <iterator>
#include <random>

using namespace nexrad;
using namespace nexrad::testing;

namespace
{

constexpr std::size_t mebibyte = std::size_t(1) << 20;

// Bytes that repeat enough for a dictionary, and not so much that it is never filled.
Bytes MakeText(std::size_t size)
{
  std::minstd_rand random(7);
  Bytes text(size);
  for (std::uint8_t& byte : text)
  {
    byte = static_cast<std::uint8_t>(random() % 23 * (random() % 3));
  }
  return text;
}

PlainFile Open(const Bytes& stored, std::vector<Damage>& damage)
{
  DecodingBudget budget(16 * mebibyte);
  return OpenContainer(stored, budget, damage);
}

} // namespace

// Worked out by hand: 65, 66, 257 ("AB"), 259 ("ABA", which the decoder has not yet defined), in
// nine bits each, lowest first.
TEST(Unlzw, ReadsACodeThatIsJustBeingDefined)
{
  const Bytes stored = {0x1F, 0x9D, 0x90, 0x41, 0x84, 0x04, 0x1C, 0x08};
  const Unpacked result = Unlzw(View(stored), mebibyte);
  EXPECT_EQ(std::string(result.bytes.begin(), result.bytes.end()), "ABABABA");
  EXPECT_TRUE(result.problem.empty()) << result.problem;
}

TEST(Unlzw, GivesBackEveryWidthAndClearedTables)
{
  const Bytes text = MakeText(300'000);
  for (const unsigned width : {10U, 12U, 16U})
  {
    const Unpacked result = Unlzw(View(Compress(text, width)), mebibyte);
    EXPECT_TRUE(result.problem.empty()) << width << ": " << result.problem;
    EXPECT_EQ(result.bytes, text) << width;
  }
}

TEST(Unlzw, StopsAtACodeThatCannotBe)
{
  const Bytes stored = {0x1F, 0x9D, 0x90, 0x41, 0xFE, 0x07}; // 65, then 511
  const Unpacked result = Unlzw(View(stored), mebibyte);
  EXPECT_EQ(result.bytes, Bytes{'A'});
  EXPECT_EQ(result.problem, "code 511 of the compress stream is not in its table");
}

TEST(Unlzw, StopsAtItsCap)
{
  const Unpacked result = Unlzw(View(Compress(Bytes(100'000, 7))), 1000);
  EXPECT_EQ(result.bytes, Bytes(1000, 7));
  EXPECT_FALSE(result.problem.empty());
}

TEST(Unlzw, RefusesAHeaderOfImpossibleWidth)
{
  EXPECT_FALSE(Unlzw(View({0x1F, 0x9D, 0x88, 0x41}), mebibyte).problem.empty());
  EXPECT_FALSE(Unlzw(View({0x1F, 0x9D}), mebibyte).problem.empty());
}

// What "gzip -dc" makes of the first two mebibytes of this file.
TEST(Unlzw, AgreesWithGzipOnARealFile)
{
  NEXRAD_REQUIRE_TEST_DATA(data);
  std::ifstream file(data / "level2/damaged/KLRX20000125_180740.Z", std::ios::binary);
  const Bytes stored{std::istreambuf_iterator<char>(file), {}};
  const Unpacked result = Unlzw(View(stored), 16 * mebibyte);
  ASSERT_EQ(result.bytes.size(), 2'949'272U);
  EXPECT_EQ(crc32(0, result.bytes.data(), 2 * mebibyte), 0x15FC8AD8U);
}

TEST(Container, TakesOffEveryStream)
{
  const Bytes text = MakeText(200'000);
  for (const Bytes& stored :
    {text, Gzip(text), Bzip2(text), Compress(text), Gzip(Bzip2(text)),
      Join({Gzip({text.begin(), text.begin() + 1000}), Gzip({text.begin() + 1000, text.end()})}),
      Join({Bzip2({text.begin(), text.begin() + 1000}), Bzip2({text.begin() + 1000, text.end()})})})
  {
    std::vector<Damage> damage;
    EXPECT_EQ(Open(stored, damage).bytes, text);
    EXPECT_TRUE(damage.empty()) << damage.front().what;
  }
}

TEST(Container, KeepsWhatCameBeforeTheBreak)
{
  const Bytes text = MakeText(200'000);
  for (Bytes stored : {Gzip(text), Compress(text)})
  {
    stored.resize(stored.size() / 2);
    std::vector<Damage> damage;
    const Bytes found = Open(stored, damage).bytes;
    EXPECT_AT_LEAST(static_cast<double>(found.size()) / static_cast<double>(text.size()), 0.25,
      "bytes before the break, part of all");
    EXPECT_TRUE(std::equal(found.begin(), found.end(), text.begin()));
  }
}

TEST(Container, NamesABrokenStreamWithItsOffset)
{
  const Bytes text = MakeText(200'000);
  Bytes stored = Gzip(text);
  stored.resize(stored.size() / 2);
  std::vector<Damage> damage;
  Open(stored, damage);
  ASSERT_EQ(damage.size(), 1U);
  EXPECT_EQ(damage[0].what, "the gzip stream ends early");
  EXPECT_EQ(damage[0].offset, stored.size());

  damage.clear();
  Open(Join({Gzip(text), {1, 2, 3}}), damage);
  ASSERT_EQ(damage.size(), 1U);
  EXPECT_EQ(damage[0].what, "3 bytes after the end of the gzip stream");
}

// A third of the budget stays for what is made of the bytes.
TEST(Container, StopsAtItsCap)
{
  for (const Bytes& stored :
    {Gzip(Bytes(3 * mebibyte)), Bzip2(Bytes(3 * mebibyte)), Compress(Bytes(3 * mebibyte))})
  {
    std::vector<Damage> damage;
    const std::size_t cost = DecodingBudget::CompressedByteCost * stored.size();
    DecodingBudget budget(1'500'000 + cost);
    const PlainFile file = OpenContainer(stored, budget, damage);
    EXPECT_EQ(file.bytes.size(), 1'000'000U);
    EXPECT_EQ(budget.Left(), 500'000U);
    ASSERT_EQ(damage.size(), 1U);
    EXPECT_NE(damage[0].what.find("more than 1000000 bytes"), std::string::npos);
  }
}

// Streams of a few bytes, and what comes out of nested ones, are paid for.
TEST(Container, AllStreamsOfAFileArePaidFromOneBudget)
{
  const Bytes text = MakeText(200'000);
  const Bytes once = Gzip(text);
  const Bytes twice = Gzip(once);
  std::vector<Damage> damage;
  DecodingBudget budget(16 * mebibyte);
  OpenContainer(twice, budget, damage);
  EXPECT_EQ(16 * mebibyte - budget.Left(),
    DecodingBudget::CompressedByteCost * (twice.size() + once.size()) + once.size() + text.size());
  DecodingBudget small(mebibyte);
  OpenContainer(Repeat(Gzip({}), 1000), small, damage);
  ASSERT_EQ(damage.size(), 1U);
  EXPECT_EQ(small.Left(), 0U);
  EXPECT_EQ(damage[0].what, small.Explain());
}

TEST(Container, MapsOffsetsThroughNestedStreams)
{
  const Bytes text = MakeText(500'000);
  const Bytes stored = Gzip(text);
  std::vector<Damage> damage;
  const PlainFile file = Open(stored, damage);
  EXPECT_EQ(file.offsets.ToStored(0), 0U);
  const auto middle = static_cast<double>(file.offsets.ToStored(250'000));
  EXPECT_WITHIN(middle / static_cast<double>(stored.size()), 0.5, 0.2,
    "offset of the middle in the file, part of its size");
  const PlainFile twice = Open(Gzip(stored), damage);
  EXPECT_WITHIN((static_cast<double>(twice.offsets.ToStored(250'000)) - middle) /
                  static_cast<double>(stored.size()),
    0.0, 0.25, "shift of the middle by a second compression, part of the size");
}

TEST(LdmRecords, FindsThemByTheirLengths)
{
  const Bytes first = MakeLdmRecord(MakeText(1000));
  const Bytes last = MakeLdmRecord(MakeText(2000), true);
  const Bytes file = Join({Bytes(24, 'h'), first, last, Bytes(100)});
  std::vector<Damage> damage;
  const auto records = FindLdmRecords(View(file), 24, KeepIn(damage));
  EXPECT_TRUE(damage.empty());
  ASSERT_EQ(records.size(), 2U);
  EXPECT_EQ(records[0].offset, 24U);
  EXPECT_EQ(records[1].offset, 24U + first.size());
  EXPECT_EQ(records[1].compressed.Size() + 4, last.size());
}

TEST(LdmRecords, FindsTheNextOneBehindAWrongLength)
{
  const Bytes record = MakeLdmRecord(MakeText(1000));
  for (const unsigned length : {0U, 5U, 100'000U, static_cast<unsigned>(record.size() + 50)})
  {
    Bytes file = Join({record, record, record});
    const Bytes wrong = BlockWriter(4).U32(0, length).Take();
    std::copy(
      wrong.begin(), wrong.end(), file.begin() + static_cast<std::ptrdiff_t>(record.size()));
    std::vector<Damage> damage;
    const auto records = FindLdmRecords(View(file), 0, KeepIn(damage));
    ASSERT_EQ(records.size(), 3U) << length;
    EXPECT_EQ(records[2].offset, 2 * record.size());
    ASSERT_FALSE(damage.empty()) << length;
  }
}

TEST(LdmRecords, PassesOverBytesThatAreNone)
{
  const Bytes record = MakeLdmRecord(MakeText(1000));
  std::vector<Damage> damage;
  const Bytes file = Join({Bytes(77, 'x'), record});
  ASSERT_EQ(FindLdmRecords(View(file), 0, KeepIn(damage)).size(), 1U);
  ASSERT_EQ(damage.size(), 1U);
  EXPECT_EQ(damage[0].offset, 0U);
  EXPECT_EQ(damage[0].what, "77 bytes that are no compressed record");
}

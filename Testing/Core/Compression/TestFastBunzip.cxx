// SPDX-License-Identifier: BSD-3-Clause
// Held against libbz2: what it compressed comes back, and nothing comes out that it would refuse.
#include "nexrad/Compression/FastBunzip.h"

#include "Level2Bytes.h"
#include "TestData.h"
#include "nexrad/Compression/LdmRecords.h"

#include <bzlib.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <utility>

using namespace nexrad;
using namespace nexrad::testing;

namespace
{

constexpr std::size_t cap = std::size_t(1) << 24;

void ExpectBack(const Bytes& bytes, int level, FastBunzip& reader)
{
  const Bytes compressed = Bzip2(bytes, level);
  const auto back = reader.Run(View(compressed), cap);
  ASSERT_TRUE(back) << bytes.size() << " bytes";
  EXPECT_EQ(back->used, compressed.size()) << bytes.size() << " bytes";
  EXPECT_TRUE(back->bytes == bytes) << bytes.size() << " bytes";
}

// Bytes of which `kinds` occur, in runs of up to `longest`.
Bytes Runs(std::size_t size, unsigned kinds, std::size_t longest, unsigned seed)
{
  std::mt19937 random(seed);
  Bytes bytes;
  while (bytes.size() < size)
  {
    bytes.insert(bytes.end(), 1 + random() % longest, static_cast<std::uint8_t>(random() % kinds));
  }
  return bytes;
}

} // namespace

TEST(FastBunzip, GivesBackWhatWasCompressed)
{
  FastBunzip reader; // one for all: nothing of a stream before may show
  ExpectBack({}, 9, reader);
  ExpectBack({7}, 1, reader);
  // Runs about the four bytes that are counted, and the count's 255.
  for (const std::size_t length : {3, 4, 5, 8, 254, 255, 258, 259, 260, 263, 518, 519, 100'000})
  {
    ExpectBack(Bytes(length, 0), 9, reader);
    Bytes between(length, 42);
    between.insert(between.begin(), {1, 42});
    between.push_back(3);
    ExpectBack(between, 9, reader);
  }
  for (const unsigned kinds : {2U, 3U, 40U, 256U})
  {
    for (const std::size_t longest : {std::size_t(1), std::size_t(6), std::size_t(2'000)})
    {
      ExpectBack(Runs(150'000, kinds, longest, kinds), 1, reader); // several blocks
      ExpectBack(Runs(30'000, kinds, longest, 7 * kinds), 9, reader);
    }
  }
}

TEST(FastBunzip, LongCodesAreFoundAsWell)
{
  // How often a byte occurs grows as Fibonacci's numbers: the rarest get codes of 17 bits, which no
  // table of ten holds.
  Bytes bytes;
  std::size_t count = 1;
  std::size_t before = 1;
  for (std::uint8_t byte = 0; byte < 24; ++byte)
  {
    bytes.insert(bytes.end(), count, byte);
    before = std::exchange(count, count + before);
  }
  std::shuffle(bytes.begin(), bytes.end(), std::mt19937(5));
  FastBunzip reader;
  ExpectBack(bytes, 9, reader);
}

TEST(FastBunzip, LeavesWhatIsDamagedToLibbz2)
{
  const Bytes bytes = Runs(3'000, 20, 12, 1);
  const Bytes whole = Bzip2(bytes, 9);
  FastBunzip reader;
  for (std::size_t size = 0; size < whole.size(); ++size)
  {
    const Bytes cut(whole.begin(), whole.begin() + static_cast<std::ptrdiff_t>(size));
    EXPECT_FALSE(reader.Run(View(cut), cap)) << size << " bytes";
  }
  for (std::size_t bit = 0; bit < 8 * whole.size(); ++bit)
  {
    Bytes damaged = whole;
    damaged[bit / 8] ^= static_cast<std::uint8_t>(1U << bit % 8);
    // Some bits make no difference: another level, or what fills the last byte.
    const auto back = reader.Run(View(damaged), cap);
    EXPECT_TRUE(!back || back->bytes == bytes) << "bit " << bit;
  }
}

TEST(FastBunzip, KeepsToItsCapAndItsStream)
{
  const Bytes bytes = Runs(5'000, 5, 400, 2);
  Bytes compressed = Bzip2(bytes, 9);
  FastBunzip reader;
  EXPECT_FALSE(reader.Run(View(compressed), bytes.size() - 1));
  EXPECT_TRUE(reader.Run(View(compressed), bytes.size()));
  const std::size_t size = compressed.size();
  compressed.insert(compressed.end(), 100, 0xFF);
  const auto whole = reader.Run(View(compressed), cap);
  EXPECT_TRUE(whole && whole->used == size);
  EXPECT_FALSE(reader.Run(ByteView(), cap));
}

TEST(FastBunzip, ReadsTheRecordsOfRealFiles)
{
  NEXRAD_REQUIRE_TEST_DATA(data);
  const std::string content = FileContent(data / "level2" / "superres" / "KDMX20250101_225441_V06");
  const Bytes file(content.begin(), content.end());
  std::vector<Damage> damage;
  const auto records = FindLdmRecords(View(file), 24, KeepIn(damage));
  ASSERT_EQ(records.size(), 43U);
  FastBunzip reader;
  Bytes room(cap);
  for (const LdmRecord& record : records)
  {
    const auto whole = reader.Run(record.compressed, cap);
    ASSERT_TRUE(whole);
    ASSERT_EQ(whole->used, record.compressed.Size());
    Bytes input(record.compressed.Data(), record.compressed.Data() + record.compressed.Size());
    auto size = static_cast<unsigned>(room.size());
    ASSERT_EQ(BZ2_bzBuffToBuffDecompress(reinterpret_cast<char*>(room.data()), &size,
                reinterpret_cast<char*>(input.data()), static_cast<unsigned>(input.size()), 0, 0),
      BZ_OK);
    ASSERT_EQ(whole->bytes.size(), size);
    EXPECT_TRUE(std::equal(whole->bytes.begin(), whole->bytes.end(), room.begin()));
  }
}

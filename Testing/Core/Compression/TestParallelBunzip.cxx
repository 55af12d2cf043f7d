// SPDX-License-Identifier: BSD-3-Clause
#include "nexrad/Compression/LdmRecords.h"

#include "Level2Bytes.h"

#include <gtest/gtest.h>

#include <stdexcept>

using namespace nexrad;
using namespace nexrad::testing;

namespace
{

constexpr std::size_t recordCount = 60;
constexpr std::size_t recordCap = std::size_t(1) << 20;

// What stands in record `index`: its number, so often that later records may be quicker to open.
Bytes ContentOf(std::size_t index)
{
  return Bytes(index % 7 * 30'000 + 1, static_cast<std::uint8_t>(index));
}

// Records end to end, with those who find them.
struct ManyRecords
{
  ManyRecords()
  {
    for (std::size_t index = 0; index < recordCount; ++index)
    {
      file = Join({file, MakeLdmRecord(ContentOf(index))});
    }
    std::vector<Damage> damage;
    records = FindLdmRecords({file.data(), file.size()}, 0, KeepIn(damage));
  }

  Bytes file;
  std::vector<LdmRecord> records;
};

} // namespace

TEST(BunzipInParallel, HandsOverEachRecordInOrder)
{
  const ManyRecords many;
  ASSERT_EQ(many.records.size(), recordCount);
  std::size_t expected = 0;
  const auto receive = [&expected](std::size_t index, Unpacked&& content)
  {
    EXPECT_EQ(index, expected++);
    EXPECT_EQ(content.problem, "");
    EXPECT_EQ(content.bytes, ContentOf(index));
  };
  BunzipInParallel(many.records, recordCap, receive);
  EXPECT_EQ(expected, recordCount);
}

TEST(BunzipInParallel, StopsAndHandsOnWhatTheReceiverThrows)
{
  const ManyRecords many;
  std::size_t received = 0;
  const auto receive = [&received](std::size_t, Unpacked&&)
  {
    if (++received == 3)
    {
      throw std::runtime_error("the third");
    }
  };
  EXPECT_THROW(BunzipInParallel(many.records, recordCap, receive), std::runtime_error);
  EXPECT_EQ(received, 3U);
}

TEST(BunzipInParallel, OneBrokenRecordLeavesTheOthersWhole)
{
  ManyRecords many;
  const std::size_t broken = 10;
  const auto stream = many.records[broken].compressed;
  const auto place = static_cast<std::size_t>(stream.Data() - many.file.data());
  many.file[place + stream.Size() / 2] ^= 0xFF;
  const auto receive = [](std::size_t index, Unpacked&& content)
  {
    EXPECT_EQ(content.problem.empty(), index != broken) << index;
    EXPECT_TRUE(index == broken || content.bytes == ContentOf(index)) << index;
  };
  BunzipInParallel(many.records, recordCap, receive);
}

TEST(BunzipInParallel, NoRecordsAreNothingToDo)
{
  BunzipInParallel({}, recordCap, [](std::size_t, Unpacked&&) { ADD_FAILURE(); });
}

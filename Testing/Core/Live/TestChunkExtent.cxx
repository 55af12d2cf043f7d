// SPDX-License-Identifier: BSD-3-Clause
#include "nexrad/Live/ChunkedVolume.h"

#include "Feed/ChunkMaker.h"
#include "Scans/RadarsOfMissouri.h"
#include "nexrad/Level2/Encoding/Level2Encoder.h"

#include <gtest/gtest.h>

using namespace nexrad;
using namespace nexrad::testing;

// A file that somebody is still writing has fewer bytes than its lengths say, wherever it ends.
TEST(ChunkExtents, EveryChunkIsCutUntilItsLastByteCame)
{
  for (const MadeChunk& chunk : CutIntoChunks(VolumeOfSweeps(keax, start, 1, 20.0)))
  {
    const std::size_t size = chunk.bytes.size();
    EXPECT_EQ(ExtentOfChunk(ByteView(chunk.bytes.data(), size)), ChunkExtent::Whole) << chunk.name;
    for (std::size_t cut = 0; cut < size; cut += 1 + size / 97)
    {
      EXPECT_NE(ExtentOfChunk(ByteView(chunk.bytes.data(), cut)), ChunkExtent::Whole)
        << chunk.name << ", " << cut << " of " << size << " bytes";
    }
    EXPECT_EQ(ExtentOfChunk(ByteView(chunk.bytes.data(), size - 1)), ChunkExtent::Cut);
  }
}

// A file of a volume may be cut between two records: the mark of the last one tells.
TEST(ChunkExtents, AFileIsWholeWithItsLastRecordAlone)
{
  Level2EncoderOptions options;
  options.messageType = 31;
  const auto bytes = EncodeLevel2(VolumeOfSweeps(keax, start, 2, 20.0), options);
  EXPECT_EQ(ExtentOfFile(ByteView(bytes.data(), bytes.size())), ChunkExtent::Whole);
  std::size_t end = 0;
  for (const MadeChunk& chunk : CutIntoChunks(VolumeOfSweeps(keax, start, 2, 20.0)))
  {
    end += chunk.bytes.size();
    EXPECT_EQ(ExtentOfFile(ByteView(bytes.data(), end)),
      end == bytes.size() ? ChunkExtent::Whole : ChunkExtent::Unknown);
  }
}

TEST(ChunkExtents, WhatHasNoLengthsIsUnknown)
{
  const std::vector<std::uint8_t> messages(5000, 7);
  EXPECT_EQ(ExtentOfChunk(ByteView(messages.data(), messages.size())), ChunkExtent::Unknown);
}

// SPDX-License-Identifier: BSD-3-Clause
#include "nexrad/Live/ChunkedVolume.h"

#include "Feed/ChunkMaker.h"
#include "Scans/RadarsOfMissouri.h"
#include "TestData.h"
#include "nexrad/Level2/Level2File.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <iterator>
#include <random>

using namespace nexrad;
using namespace nexrad::testing;

namespace
{

ChunkedVolume::Arrival Add(ChunkedVolume& volume, const MadeChunk& chunk)
{
  return volume.Add({chunk.number, chunk.kind}, chunk.name, chunk.bytes);
}

// All that a decoder says of a volume, the words of the gates too.
void ExpectSame(const RadarVolume& made, const RadarVolume& expected)
{
  ASSERT_EQ(made.sweeps.size(), expected.sweeps.size());
  EXPECT_EQ(made.file, expected.file);
  EXPECT_EQ(made.complete, expected.complete);
  EXPECT_EQ(made.site.name, expected.site.name);
  EXPECT_EQ(made.notes, expected.notes);
  ASSERT_EQ(made.damage.size(), expected.damage.size());
  for (std::size_t i = 0; i < made.damage.size(); ++i)
  {
    EXPECT_EQ(made.damage[i].what, expected.damage[i].what);
    EXPECT_EQ(made.damage[i].offset, expected.damage[i].offset);
  }
  for (std::size_t s = 0; s < made.sweeps.size(); ++s)
  {
    EXPECT_EQ(made.sweeps[s].waveform, expected.sweeps[s].waveform);
    ASSERT_EQ(made.sweeps[s].rays.size(), expected.sweeps[s].rays.size());
    for (std::size_t r = 0; r < made.sweeps[s].rays.size(); ++r)
    {
      const Ray& a = made.sweeps[s].rays[r];
      const Ray& b = expected.sweeps[s].rays[r];
      ASSERT_EQ(a.time, b.time);
      ASSERT_EQ(a.azimuth, b.azimuth);
      for (std::size_t m = 0; m < a.moments.size(); ++m)
      {
        ASSERT_EQ(a.moments[m].gates, b.moments[m].gates);
        for (std::size_t gate = 0; gate < a.moments[m].gates; ++gate)
        {
          ASSERT_EQ(a.moments[m].Raw(gate), b.moments[m].Raw(gate));
        }
      }
    }
  }
}

std::vector<MadeChunk> ChunksIn(const std::filesystem::path& folder)
{
  std::vector<MadeChunk> chunks;
  for (const Chunk& chunk : ListChunks(folder))
  {
    std::ifstream file(chunk.path, std::ios::binary);
    chunks.push_back({chunk.path.filename().string(), chunk.number, chunk.kind,
      std::vector<std::uint8_t>(std::istreambuf_iterator<char>(file), {})});
  }
  return chunks;
}

} // namespace

TEST(ChunkedVolumes, InAnyOrderAndRepeatedlyGiveTheVolumeOfTheFolder)
{
  const TemporaryFolder folder;
  std::vector<MadeChunk> chunks = CutIntoChunks(VolumeOfSweeps(keax, start, 4, 20.0));
  ASSERT_EQ(chunks.size(), 13U) << "metadata, and three records a sweep";
  WriteChunks(folder.Path(), chunks);
  const RadarVolume expected = ReadLevel2(folder.Path());
  ASSERT_EQ(expected.sweeps.size(), 4U);
  std::mt19937 random(16);
  for (int attempt = 0; attempt < 20; ++attempt)
  {
    ChunkedVolume volume(folder.Path().string(), {});
    std::vector<MadeChunk> sent = chunks;
    sent.insert(sent.end(), chunks.begin(), chunks.begin() + 5);
    std::shuffle(sent.begin(), sent.end(), random);
    int repeated = 0;
    for (const MadeChunk& chunk : sent)
    {
      repeated += Add(volume, chunk) == ChunkedVolume::Arrival::Repeated ? 1 : 0;
    }
    EXPECT_EQ(repeated, 5);
    EXPECT_TRUE(volume.HasEnd() && volume.Missing().empty());
    EXPECT_EQ(volume.DecodedCount(), 13U);
    ExpectSame(volume.Volume(), expected);
  }
}

TEST(ChunkedVolumes, ASweepIsCompleteWithItsLastRay)
{
  ChunkedVolume volume("folder", {});
  const auto chunks = CutIntoChunks(VolumeOfSweeps(keax, start, 3, 20.0));
  for (std::size_t i = 0; i < chunks.size(); ++i)
  {
    Add(volume, chunks[i]);
    RadarVolume decoded = volume.Volume();
    const auto sweeps = ArrivedSweeps(decoded);
    ASSERT_EQ(sweeps.size(), (i + 2) / 3) << chunks[i].name;
    DropSweepInProgress(decoded);
    EXPECT_EQ(decoded.sweeps.size(), i / 3) << chunks[i].name;
    for (std::size_t s = 0; s < sweeps.size(); ++s)
    {
      EXPECT_EQ(sweeps[s].complete, s < i / 3) << chunks[i].name << ", sweep " << s;
      EXPECT_EQ(sweeps[s].rays, s < i / 3 ? 360U : 120U * ((i - 1) % 3 + 1));
    }
  }
}

// The radar may break a sweep off; the next one shows it.
TEST(ChunkedVolumes, ASweepThatBreaksOffIsCompleteWithTheNext)
{
  RadarVolume broken = VolumeOfSweeps(keax, start, 2, 20.0);
  broken.sweeps[0].rays.resize(240);
  ChunkedVolume volume("folder", {});
  const auto chunks = CutIntoChunks(broken);
  for (std::size_t i = 0; i < 3; ++i)
  {
    Add(volume, chunks[i]);
  }
  EXPECT_FALSE(ArrivedSweeps(volume.Volume()).at(0).complete);
  Add(volume, chunks[3]);
  EXPECT_TRUE(ArrivedSweeps(volume.Volume()).at(0).complete);
}

TEST(ChunkedVolumes, WhatFollowsAMissingChunkWaitsForIt)
{
  const TemporaryFolder folder;
  const auto chunks = CutIntoChunks(VolumeOfSweeps(keax, start, 3, 20.0));
  ChunkedVolume volume(folder.Path().string(), {});
  for (const MadeChunk& chunk : chunks)
  {
    if (chunk.number != 5)
    {
      Add(volume, chunk);
    }
  }
  EXPECT_EQ(volume.Missing(), std::vector<int>{5});
  EXPECT_TRUE(volume.HasEnd());
  EXPECT_EQ(volume.DecodedCount(), 4U);
  EXPECT_EQ(ArrivedSweeps(volume.Volume()).size(), 1U);

  volume.SkipMissing();
  EXPECT_EQ(volume.DecodedCount(), 9U);
  auto others = chunks;
  others.erase(others.begin() + 4);
  WriteChunks(folder.Path(), others);
  ExpectSame(volume.Volume(), ReadLevel2(folder.Path()));

  EXPECT_EQ(Add(volume, chunks[4]), ChunkedVolume::Arrival::Late);
  EXPECT_TRUE(volume.HasEnd() && volume.Missing().empty());
  WriteChunks(folder.Path(), chunks);
  ExpectSame(volume.Volume(), ReadLevel2(folder.Path()));
}

TEST(ChunkedVolumes, OtherBytesTakeThePlaceOfThoseBefore)
{
  const auto chunks = CutIntoChunks(VolumeOfSweeps(keax, start, 1, 20.0));
  ChunkedVolume volume("folder", {});
  for (MadeChunk chunk : chunks)
  {
    chunk.bytes.resize(chunk.number == 3 ? chunk.bytes.size() / 2 : chunk.bytes.size());
    Add(volume, chunk);
  }
  EXPECT_LT(volume.Volume().RayCount(), 360U);
  EXPECT_EQ(Add(volume, chunks[2]), ChunkedVolume::Arrival::Replaced);
  EXPECT_EQ(volume.Volume().RayCount(), 360U);
}

TEST(ChunkedVolumes, AClosedOneKnowsItsChunks)
{
  const auto chunks = CutIntoChunks(VolumeOfSweeps(keax, start, 1, 20.0));
  ChunkedVolume volume("folder", {});
  Add(volume, chunks[0]);
  Add(volume, chunks[1]);
  volume.Close();
  EXPECT_EQ(Add(volume, chunks[1]), ChunkedVolume::Arrival::Repeated);
  EXPECT_EQ(Add(volume, chunks[2]), ChunkedVolume::Arrival::Closed);
}

// The three real sets of chunks, in an order of their own.
TEST(ChunkedVolumes, OfRealRadarsAreThoseOfTheirFolders)
{
  NEXRAD_REQUIRE_TEST_DATA(data);
  std::mt19937 random(16);
  for (const char* name : {"KLOT-20210729", "TORD-20260811", "KHDX-20240401-partial"})
  {
    const std::filesystem::path folder = data / "level2" / "chunks" / name;
    std::vector<MadeChunk> chunks = ChunksIn(folder);
    std::shuffle(chunks.begin(), chunks.end(), random);
    ChunkedVolume volume(folder.string(), {});
    for (const MadeChunk& chunk : chunks)
    {
      EXPECT_EQ(ExtentOfChunk(ByteView(chunk.bytes.data(), chunk.bytes.size())), ChunkExtent::Whole)
        << chunk.name;
      Add(volume, chunk);
    }
    volume.SkipMissing();
    EXPECT_EQ(volume.DecodedCount(), chunks.size());
    ExpectSame(volume.Volume(), ReadLevel2(folder));
  }
}

// SPDX-License-Identifier: BSD-3-Clause
// Small files that would take minutes or gigabytes if the reader trusted them. What took minutes
// exceeds the limit of time that CTest sets for a test.
#include "nexrad/Compression/LdmRecords.h"
#include "nexrad/Level2/Level2File.h"
#include "nexrad/Level2/Messages/MessageStream.h"

#include "Faults/HostileFiles.h"
#include "Level2Bytes.h"
#include "Remarks.h"
#include "Tolerance.h"

#include <gtest/gtest.h>

#include <algorithm>

using namespace nexrad;
using namespace nexrad::testing;

namespace
{

// Length and beginning of a record without content. Its blocks are the smallest: libbz2 takes 0.4
// MB for each such record, not 3.6 MB, which the address sanitiser would mark byte by byte.
Bytes EmptyRecord(std::uint32_t length)
{
  return BlockWriter(14).U32(0, length).Text(4, "BZh11AY&SY").Take();
}

// A volume of one sweep: rays a tenth of a degree apart, the first changed.
RadarVolume DecodeSweep(const RayPlan& first, const RayPlan& others, unsigned rays)
{
  std::vector<Bytes> parts = {MakeVolumeHeader()};
  RayPlan ray = first;
  ray.status = 3;
  parts.push_back(MakeMessage31(ray));
  ray = others;
  for (unsigned index = 1; index < rays; ++index)
  {
    ray.number = index + 1;
    ray.status = index + 1 == rays ? 4 : 1;
    ray.azimuth = others.azimuth + 0.1 * (index % 3000);
    parts.push_back(MakeMessage31(ray));
  }
  return DecodeLevel2(Join(parts), "file");
}

RayPlan PlanOf(unsigned gates)
{
  RayPlan plan;
  plan.moments[0].gates = gates;
  plan.moments[0].words = Bytes(gates, 66);
  return plan;
}

} // namespace

// A decompressor of its own for each took 0.2 ms.
TEST(HostileBytes, AMillionEmptyBzip2Streams)
{
  const Bytes empty =
    BlockWriter(14).Text(0, "BZh9").U32(4, 0x17724538).U16(8, 0x5090).Take(); // no block
  const Bytes stored = Repeat(empty, 1'000'000);
  const RadarVolume volume = DecodeLevel2(stored, "file");
  EXPECT_TRUE(HasDamage(volume, "no ray can be read"));
}

// Each length leads to the zeros, which were read for each record up to the byte behind them.
TEST(HostileBytes, LengthsThatAllLeadToTheSameZeros)
{
  constexpr std::uint32_t count = 20'000;
  std::vector<Bytes> parts = {MakeVolumeHeader()};
  for (std::uint32_t index = 0; index < count; ++index)
  {
    parts.push_back(EmptyRecord(14 * (count - index) - 4));
  }
  parts.emplace_back(std::size_t(16) << 20, std::uint8_t(0));
  parts.push_back({1});
  const RadarVolume volume = DecodeLevel2(Join(parts), "file");
  EXPECT_TRUE(HasDamage(volume, "no ray can be read"));
  EXPECT_EQ(volume.damage.size(), DamageList::mostEntries + 2); // how many more, and no ray
}

TEST(HostileBytes, RecordsWithoutEnd)
{
  const Bytes stored =
    Join({MakeVolumeHeader(), Repeat(EmptyRecord(1'234'567), MostLdmRecords + 5)});
  std::size_t reported = 0;
  const auto records =
    FindLdmRecords(View(stored), 24, [&reported](std::size_t, const std::string&) { ++reported; });
  EXPECT_EQ(records.size(), MostLdmRecords);
  EXPECT_EQ(reported, MostLdmRecords + 1);
  const RadarVolume volume = DecodeLevel2(stored, "file");
  EXPECT_TRUE(HasDamage(volume, "more than 100000 compressed records; the rest is left"));
  EXPECT_AT_MOST(volume.damage.size(), 6U, "entries of damage"); // equal ones are counted
}

// The stream keeps no list: each problem is reported before the next is looked for.
TEST(HostileBytes, ProblemsOfAStreamAreReportedAsTheyAreFound)
{
  const Bytes header = MakeVolumeHeader();
  const Bytes stored = Join({Repeat(header, 3), MakeMessage2(21, 190), Repeat(header, 4)});
  std::size_t reported = 0;
  MessageStream stream(View(stored), [&reported](std::size_t, const std::string&) { ++reported; });
  ASSERT_TRUE(stream.Next());
  EXPECT_EQ(reported, 3U);
  EXPECT_FALSE(stream.Next());
  EXPECT_EQ(reported, 7U);
}

// A table of the sweep would hold 2000 × 65535 gates, a hundred times what the file holds.
TEST(HostileBytes, OneWideRayAmongManyNarrowOnes)
{
  const RadarVolume volume = DecodeSweep(PlanOf(65'535), PlanOf(4), 2'000);
  ASSERT_EQ(volume.RayCount(), 2'000U);
  const std::size_t widest = volume.sweeps[0].rays[0].Row(MomentName::REF).gates;
  EXPECT_AT_MOST(static_cast<double>(widest * 2'000) / (65'535 + 1'999 * 4), 2.0,
    "gates in memory, times those of the file");
  EXPECT_EQ(volume.sweeps[0].rays[1].Row(MomentName::REF).gates, 4U);
  EXPECT_TRUE(HasDamage(volume, "REF has 65535 gates, the rays of its sweep 36 in the mean"));
  // A sweep of the usual size keeps all, however its rays differ.
  const RadarVolume usual = DecodeSweep(PlanOf(1'832), PlanOf(4), 720);
  EXPECT_EQ(usual.sweeps[0].rays[0].Row(MomentName::REF).gates, 1'832U);
  EXPECT_TRUE(usual.damage.empty());
}

TEST(HostileBytes, SweepsWithoutEnd)
{
  std::vector<Bytes> parts = {MakeVolumeHeader()};
  RayPlan ray = PlanOf(1'000);
  for (unsigned index = 0; index < 2'500; ++index)
  {
    ray.status = 3; // each a volume of its own
    ray.milliseconds += 100;
    parts.push_back(MakeMessage31(ray));
  }
  const RadarVolume volume = DecodeLevel2(Join(parts), "file");
  EXPECT_EQ(volume.sweeps.size(), 2'000U);
  EXPECT_TRUE(HasDamage(volume, "more than 2000 sweeps; the rest is left"));
}

// Two thousand cycles with all records and all damage each would be four million of them.
TEST(HostileBytes, CyclesShareTheirFilesMemory)
{
  std::vector<Bytes> parts = {MakeVolumeHeader()};
  RayPlan ray;
  ray.status = 3;
  for (int index = 0; index < 5; ++index)
  {
    parts.push_back(MakeLdmRecord(MakeMessage31(ray)));
    ray.milliseconds += 100;
  }
  parts.push_back({1, 2, 3});
  const RadarVolume volume = DecodeLevel2(Join(parts), "file");
  ASSERT_EQ(volume.buffers.size(), 5U);
  ASSERT_FALSE(volume.damage.empty());
  const std::vector<RadarVolume> cycles = SplitCycles(volume);
  ASSERT_EQ(cycles.size(), 5U);
  EXPECT_EQ(cycles[0].damage.size(), volume.damage.size());
  for (const RadarVolume& cycle : cycles)
  {
    ASSERT_EQ(cycle.buffers.size(), 1U);
    const std::vector<std::uint8_t>& buffer = *cycle.buffers[0];
    const std::uint8_t* words = cycle.sweeps[0].rays[0].Row(MomentName::REF).words;
    EXPECT_TRUE(words >= buffer.data() && words < buffer.data() + buffer.size());
  }
  EXPECT_TRUE(cycles[1].damage.empty());
}

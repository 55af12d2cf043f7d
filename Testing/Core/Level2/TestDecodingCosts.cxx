// SPDX-License-Identifier: BSD-3-Clause
// What small files may cost that were made to cost as much as possible: memory, and numbers of what
// takes time. Memory is counted by what is allocated, and no time is measured.
#include "nexrad/Compression/DamageList.h"
#include "nexrad/Compression/DecodingBudget.h"
#include "nexrad/Level2/Level2File.h"
#include "nexrad/Quality/EchoClassification.h"

#include "Faults/AllocationPeak.h"
#include "Faults/HostileFiles.h"
#include "Remarks.h"
#include "TestData.h"
#include "Tolerance.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <iterator>
#include <set>
#include <string>

using namespace nexrad;
using namespace nexrad::testing;

namespace
{

constexpr double mebibyte = 1 << 20;

RadarVolume DecodeAll(const Bytes& stored, const Level2Options& options = {})
{
  return DecodeLevel2(stored, "file", options);
}

std::size_t CountGates(const RadarVolume& volume)
{
  std::size_t gates = 0;
  for (const Sweep& sweep : volume.sweeps)
  {
    for (const Ray& ray : sweep.rays)
    {
      for (const MomentRow& row : ray.moments)
      {
        gates += row.gates;
      }
    }
  }
  return gates;
}

// The largest number of different properties that rays of a moment and sweep have.
template <class PropertyOf>
std::size_t MostDifferent(const RadarVolume& volume, const PropertyOf& propertyOf)
{
  std::size_t most = 0;
  for (const Sweep& sweep : volume.sweeps)
  {
    for (const MomentName name : AllMoments)
    {
      std::set<decltype(propertyOf(MomentRow()))> different;
      for (const Ray& ray : sweep.rays)
      {
        if (ray.Row(name).gates > 0)
        {
          different.insert(propertyOf(ray.Row(name)));
        }
      }
      most = std::max(most, different.size());
    }
  }
  return most;
}

} // namespace

// What is decoded, and what quality control, which `info` runs, makes of it.
TEST(DecodingCosts, OfHostileFilesAreBounded)
{
  double mostMemory = 0.0;
  std::size_t mostRays = 0;
  std::size_t mostSweeps = 0;
  std::size_t mostGates = 0;
  for (const HostileFile& file : MakeHostileFiles())
  {
    const Bytes stored = file.make();
    const AllocationPeak peak;
    const RadarVolume volume = DecodeAll(stored);
    ClassifyEcho(volume);
    EXPECT_LE(volume.damage.size(), DamageList::mostEntries + 5) << file.name;
    // What larger files may cost is in proportion to their size.
    const double part = (DecodingBudget::FreeBytes + 100.0 * static_cast<double>(stored.size())) /
                        static_cast<double>(DecodingBudget::FreeBytes);
    const double memory = static_cast<double>(peak.Bytes()) / mebibyte / part;
    EXPECT_LE(memory, 240.0) << file.name;
    mostMemory = std::max(mostMemory, memory);
    mostRays = std::max(mostRays, static_cast<std::size_t>(double(volume.RayCount()) / part));
    mostSweeps =
      std::max(mostSweeps, static_cast<std::size_t>(double(volume.sweeps.size()) / part));
    mostGates = std::max(mostGates, static_cast<std::size_t>(double(CountGates(volume)) / part));
  }
  EXPECT_AT_MOST(mostMemory, 240.0, "allocated for a hostile file, MiB for each free budget");
  EXPECT_AT_MOST(mostRays, 50'000U, "rays of a hostile file, for each free budget");
  EXPECT_AT_MOST(mostSweeps, 800U, "sweeps of a hostile file, for each free budget");
  EXPECT_AT_MOST(static_cast<double>(mostGates) / 1e6, 50.0,
    "million gates of a hostile file, for each free budget");
}

// Rays of the start of a file whose bytes have no end.
TEST(DecodingCosts, LeaveWhatIsReadFirst)
{
  const Bytes volume = MakeSmallVolume(31);
  const Bytes stored = Join({Gzip(volume), GzipOfRepeated(Bytes(1 << 20), 80)});
  const RadarVolume decoded = DecodeAll(stored);
  EXPECT_EQ(decoded.RayCount(), 24U);
  EXPECT_TRUE(HasDamage(decoded, "when decompressed; the rest is left"));
}

// A budget of the caller's, as with a limit of memory.
TEST(DecodingCosts, AreLessWhereTheFreeBytesAreFewer)
{
  RayPlan first;
  std::vector<Bytes> parts = {MakeVolumeHeader()};
  for (first.status = 0; parts.size() <= 40; first.milliseconds += 20'000)
  {
    parts.push_back(MakeSweepBytes(31, first, 360, 2));
  }
  const Bytes stored = Gzip(Join(parts));
  Level2Options options;
  options.freeBytes = 0;
  const RadarVolume decoded = DecodeAll(stored, options);
  EXPECT_LT(decoded.RayCount(), 40U * 360U);
  EXPECT_TRUE(HasDamage(decoded, "decoding takes more than " +
                                   std::to_string(DecodingBudget::BytesForStored * stored.size()) +
                                   " bytes of memory"));
  EXPECT_EQ(DecodeAll(stored).RayCount(), 40U * 360U);
}

// Who makes a table of a sweep makes one for each range of the first gate, distance of gates and
// coding: rays that all differ made thousands, and their comparison took minutes.
TEST(DecodingCosts, RaysOfASweepAgree)
{
  std::vector<Bytes> parts = {MakeVolumeHeader()};
  RayPlan ray;
  for (unsigned index = 0; index < 300; ++index)
  {
    ray.status = index == 0 ? 3 : index == 299 ? 4 : 1;
    ray.number = index + 1;
    ray.azimuth = index;
    ray.moments[0].firstGate = static_cast<int>(index % 100);
    ray.moments[0].offset = 60.0F + static_cast<float>(index / 100);
    parts.push_back(MakeMessage31(ray));
  }
  const RadarVolume volume = DecodeAll(Join(parts));
  ASSERT_EQ(volume.RayCount(), 300U);
  EXPECT_EQ(MostDifferent(volume, [](const MomentRow& row) { return row.offset; }), 3U);
  EXPECT_EQ(MostDifferent(volume, [](const MomentRow& row) { return row.firstGate; }), 4U);
  EXPECT_TRUE(HasDamage(volume, "REF has its gates where few rays of its sweep have theirs"));
}

// No file of the archive costs so much that something is left out, and the one that compresses most
// has room.
TEST(DecodingCosts, OfRealFilesAreWithinTheBudget)
{
  NEXRAD_REQUIRE_TEST_DATA(data);
  std::ifstream file(data / "level2/superres/example_nexrad_archive_msg31.bz2", std::ios::binary);
  const Bytes stored{std::istreambuf_iterator<char>(file), {}};
  Level2Options options;
  options.freeBytes = DecodingBudget::FreeBytes * 9 / 10;
  const RadarVolume volume = DecodeAll(stored, options);
  EXPECT_EQ(volume.RayCount(), 7'200U);
  EXPECT_TRUE(volume.damage.empty());
}

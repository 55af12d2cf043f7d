// SPDX-License-Identifier: BSD-3-Clause
#include "nexrad/Level2/Level2File.h"
#include "nexrad/Model/MomentLimits.h"
#include "nexrad/Model/MomentSummary.h"
#include "nexrad/Polar/PolarVolume.h"

#include "SweepMaker.h"
#include "TestData.h"
#include "Tolerance.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <map>
#include <set>
#include <string>

using namespace nexrad;
namespace fs = std::filesystem;

namespace
{

std::string Describe(const RadarVolume& volume)
{
  std::string text = volume.file;
  for (const Damage& damage : volume.damage)
  {
    text += "\n  offset " + std::to_string(damage.offset) + ": " + damage.what;
  }
  return text;
}

void ExpectSameRays(const Sweep& first, const Sweep& second)
{
  ASSERT_EQ(first.rays.size(), second.rays.size());
  for (std::size_t index = 0; index < first.rays.size(); ++index)
  {
    const Ray& one = first.rays[index];
    const Ray& other = second.rays[index];
    ASSERT_EQ(one.time, other.time);
    ASSERT_EQ(one.azimuth, other.azimuth);
    ASSERT_EQ(one.elevation, other.elevation);
    ASSERT_EQ(one.nyquist, other.nyquist);
    for (const MomentName name : AllMoments)
    {
      const MomentRow& row = one.Row(name);
      ASSERT_EQ(row.gates, other.Row(name).gates);
      ASSERT_TRUE(std::equal(
        row.words, row.words + std::size_t(row.gates) * row.wordBits / 8, other.Row(name).words));
    }
  }
}

void ExpectTwins(const fs::path& first, const fs::path& second)
{
  const RadarVolume one = ReadLevel2(first);
  const RadarVolume other = ReadLevel2(second);
  ASSERT_AT_LEAST(one.RayCount(), 3000U, "rays of a file");
  ASSERT_EQ(one.sweeps.size(), other.sweeps.size());
  for (std::size_t index = 0; index < one.sweeps.size(); ++index)
  {
    ExpectSameRays(one.sweeps[index], other.sweeps[index]);
  }
}

} // namespace

TEST(RealFiles, TwinsInOtherContainersHoldTheSameRays)
{
  NEXRAD_REQUIRE_TEST_DATA(data);
  const fs::path folder = data / "level2/superres";
  ExpectTwins(
    folder / "PGUA20160602_055618_V06.compress.raw", folder / "PGUA20160602_055618_V06.raw.gz");
  ExpectTwins(folder / "KTLX20100501_000444.bin", folder / "KTLX20100501_000444_V03.gz");
}

// A whole file in one bzip2 stream, which no oracle describes.
TEST(RealFiles, AnArchiveOfOneStreamIsRead)
{
  NEXRAD_REQUIRE_TEST_DATA(data);
  const RadarVolume volume = ReadLevel2(data / "level2/superres/example_nexrad_archive_msg31.bz2");
  EXPECT_FALSE(volume.sweeps.empty()) << Describe(volume);
  EXPECT_TRUE(volume.site.position) << Describe(volume);
}

// At least the rays that a plain walk from frame to frame finds before it loses its way.
TEST(RealFiles, DamagedFilesGiveTheirReadableRays)
{
  NEXRAD_REQUIRE_TEST_DATA(data);
  const std::map<std::string, std::size_t> readable = {{"KATX20160427_095248_V06.gz", 360},
    {"KBMX20160509_093623_V06.gz", 0}, {"KCBW20150113_174533_V06.gz", 6},
    {"KGLD20050104_183133.gz", 1103}, {"KILN20080107_173809.gz", 287},
    {"KIWX20160429_194300_V06.gz", 76}, {"KJGX19700101_000000_V06", 0}, {"KJKL_20240227_102059", 0},
    {"KLRX20000125_180740.Z", 650}, {"KLVX20050106_163401.gz", 1573}, {"KMPX20060106_184002.gz", 3},
    {"KTLX19910720_160529.gz", 619}};
  for (const auto& [name, rays] : readable)
  {
    const RadarVolume volume = ReadLevel2(data / "level2/damaged" / name);
    EXPECT_GE(volume.RayCount(), rays) << Describe(volume);
    EXPECT_EQ(HoldsMetadataAlone(volume), rays == 0) << name;
    for (const Damage& damage : volume.damage)
    {
      EXPECT_LE(damage.offset, fs::file_size(data / "level2/damaged" / name)) << damage.what;
    }
  }
}

// The framing is lost in mid-file, by as much as 98 rays; both ends of the volume are there.
TEST(RealFiles, ReadingGoesOnBehindLostFraming)
{
  NEXRAD_REQUIRE_TEST_DATA(data);
  const fs::path folder = data / "level2/damaged";
  for (const char* name : {"KGLD20050104_183133.gz", "KLVX20050106_163401.gz"})
  {
    const RadarVolume volume = ReadLevel2(folder / name);
    EXPECT_TRUE(volume.complete) << Describe(volume);
    EXPECT_AT_LEAST(volume.RayCount(), 3900U, "rays of a file with lost framing")
      << Describe(volume);
    EXPECT_AT_LEAST(volume.sweeps.back().MeanElevation(), 19.0,
      "elevation of the last sweep behind the damage, degrees");
  }
}

TEST(RealFiles, ChunkFoldersAreVolumes)
{
  NEXRAD_REQUIRE_TEST_DATA(data);
  const fs::path chunks = data / "level2/chunks";
  const RadarVolume whole = ReadLevel2(chunks / "KLOT-20210729");
  EXPECT_EQ(whole.RayCount(), 11'160U);
  EXPECT_TRUE(whole.damage.empty()) << Describe(whole);
  EXPECT_EQ(whole.site.name, "KLOT");
  EXPECT_EQ(whole.coveragePatternNumber, 212);
  const RadarVolume terminal = ReadLevel2(chunks / "TORD-20260811");
  EXPECT_EQ(terminal.RayCount(), 5'760U);
  EXPECT_TRUE(terminal.damage.empty()) << Describe(terminal);
  for (const char* name : {"KHDX-20240401-partial", "KABR-20240328-stray", "KLBB-single"})
  {
    const RadarVolume part = ReadLevel2(chunks / name);
    EXPECT_AT_LEAST(part.RayCount(), 120U, "rays of a part of a volume") << name;
    EXPECT_FALSE(part.complete) << name;
    EXPECT_FALSE(part.damage.empty()) << name;
    EXPECT_TRUE(part.site.position) << name;
  }
}

TEST(RealFiles, SeveralCyclesUnderOneHeaderComeApart)
{
  NEXRAD_REQUIRE_TEST_DATA(data);
  const RadarVolume volume = ReadLevel2(data / "level2/pairs/KBBX20060113_170337.gz");
  const std::vector<RadarVolume> cycles = SplitCycles(volume);
  ASSERT_EQ(cycles.size(), 4U);
  std::size_t rays = 0;
  for (const RadarVolume& cycle : cycles)
  {
    EXPECT_EQ(cycle.sweeps.size(), 17U);
    rays += cycle.RayCount();
  }
  EXPECT_EQ(rays, volume.RayCount());
}

TEST(RealFiles, MidnightAndTheHeadersTimeAreNotes)
{
  NEXRAD_REQUIRE_TEST_DATA(data);
  const auto notes = [&data](const char* file)
  {
    std::string all;
    for (const std::string& note : ReadLevel2(data / "level2" / file).notes)
    {
      all += note + '\n';
    }
    return all;
  };
  EXPECT_NE(notes("legacy/KTLX19990503_235621.gz").find("midnight"), std::string::npos);
  EXPECT_NE(notes("legacy/KVWX_20050626_221551.gz").find("header's time"), std::string::npos);
  EXPECT_EQ(notes("superres/KLSX20251229_065156_V06"), "");
}

// The file holds spectrum widths of -32.5 m/s: words that were halved at the edges of echo. They
// stay what an independent decoder finds there; `info` says so, and merging leaves them out.
TEST(RealFiles, WidthsThatCannotBeAreNotedAndNotMerged)
{
  NEXRAD_REQUIRE_TEST_DATA(data);
  const RadarVolume volume = ReadLevel2(data / "level2" / "legacy" / "KVWX_20050626_221551.gz");
  EXPECT_EQ(Summarize(volume.sweeps[4], MomentName::SW).minimum, -32.5);
  const std::string note = DescribeImpossibleGates(volume.sweeps);
  EXPECT_EQ(note.rfind("3093 gates have a spectrum width below 0 m/s", 0), 0U) << note;
  for (const PolarSweep& each : MakePolarVolume(volume, MomentName::SW).sweeps)
  {
    const nexrad::testing::NumberSweep sweep = nexrad::testing::NumbersOf(each);
    for (std::size_t gate = 0; gate < sweep.values.size(); ++gate)
    {
      ASSERT_TRUE(sweep.states[gate] != GateState::Valid || sweep.values[gate] >= 0.0F) << gate;
    }
  }
}

// SPDX-License-Identifier: BSD-3-Clause
#include "nexrad/Level2/Level2File.h"
#include "nexrad/Model/SiteTable.h"
#include "nexrad/System/Error.h"

#include "Level2Bytes.h"
#include "Remarks.h"
#include "TestData.h"
#include "Tolerance.h"

#include <gtest/gtest.h>

#include <sys/stat.h>

#include <fstream>

using namespace nexrad;
using namespace nexrad::testing;

namespace
{

RadarVolume Decode(const Bytes& bytes, const std::string& name = "file", Level2Options options = {})
{
  return DecodeLevel2(bytes, name, options);
}

RadarVolume DecodeRays(const std::vector<Bytes>& rays)
{
  return Decode(Join({MakeVolumeHeader(), Join(rays)}));
}

void Write(const std::filesystem::path& path, const Bytes& bytes)
{
  std::ofstream(path, std::ios::binary)
    .write(reinterpret_cast<const char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
}

// The rays of a small volume in the container, behind its header.
Bytes InRecords(unsigned messageType, std::size_t recordBytes)
{
  const Bytes volume = MakeSmallVolume(messageType);
  std::vector<Bytes> parts = {{volume.begin(), volume.begin() + 24}};
  for (std::size_t place = 24; place < volume.size(); place += recordBytes)
  {
    const std::size_t end = std::min(place + recordBytes, volume.size());
    parts.push_back(MakeLdmRecord({volume.begin() + static_cast<std::ptrdiff_t>(place),
                                    volume.begin() + static_cast<std::ptrdiff_t>(end)},
      end == volume.size()));
  }
  return Join(parts);
}

} // namespace

TEST(Assembly, ReadsEveryContainerAlike)
{
  for (const unsigned type : {1U, 31U})
  {
    const Bytes bare = MakeSmallVolume(type);
    const std::size_t messageBytes = type == 1 ? 2432 : 227 * 2432; // message 31: one record
    for (const Bytes& stored :
      {bare, Gzip(bare), Bzip2(bare), Compress(bare), InRecords(type, messageBytes),
        Gzip(InRecords(type, messageBytes)), Bzip2(InRecords(type, messageBytes))})
    {
      const RadarVolume volume = Decode(stored);
      EXPECT_EQ(volume.RayCount(), 24U);
      ASSERT_EQ(volume.sweeps.size(), 2U);
      EXPECT_TRUE(volume.complete);
      EXPECT_TRUE(volume.damage.empty()) << volume.damage.front().what;
      EXPECT_EQ(volume.messageType, static_cast<int>(type));
      EXPECT_EQ(volume.coveragePatternNumber, 21);
      ASSERT_TRUE(volume.coveragePattern);
      EXPECT_EQ(volume.coveragePattern->cuts.size(), 2U);
      EXPECT_EQ(volume.sweeps[1].rays[11].Row(MomentName::REF).Raw(3), 66U);
    }
  }
}

TEST(Assembly, EmptyAndForeignFilesHaveNoSweeps)
{
  EXPECT_TRUE(HasDamage(Decode({}), "the file is empty"));
  const RadarVolume foreign = Decode(Bytes(5000, 'x'));
  EXPECT_TRUE(foreign.sweeps.empty());
  EXPECT_TRUE(HasDamage(foreign, "no ray can be read"));
  EXPECT_FALSE(foreign.messageType);
  EXPECT_FALSE(foreign.Start());
  EXPECT_THROW(ReadLevel2("/nonexistent/file"), Error);
}

TEST(Assembly, ASweepBeginsWhereTheDesignSays)
{
  RayPlan ray;
  ray.status = 3;
  std::vector<Bytes> rays = {MakeMessage31(ray)};
  const auto add = [&](unsigned status, unsigned cut, double azimuth)
  {
    ray.status = status;
    ray.cut = cut;
    ray.azimuth = azimuth;
    ++ray.number;
    rays.push_back(MakeMessage31(ray));
  };
  add(1, 1, 46.0);
  add(1, 2, 47.0); // the number changes
  add(2, 2, 48.0);
  add(0, 2, 49.0); // a cut starts
  add(5, 2, 50.0); // the last cut starts
  add(1, 2, 51.0);
  const RadarVolume volume = DecodeRays(rays);
  std::vector<std::size_t> counts;
  for (const Sweep& sweep : volume.sweeps)
  {
    counts.push_back(sweep.rays.size());
  }
  EXPECT_EQ(counts, (std::vector<std::size_t>{2, 2, 1, 2}));
}

TEST(Assembly, ASweepEndsAfterMoreThan400Degrees)
{
  RayPlan ray;
  std::vector<Bytes> rays;
  for (int index = 0; index < 450; ++index)
  {
    ray.azimuth = index % 360;
    ray.number = static_cast<unsigned>(index + 1);
    rays.push_back(MakeMessage31(ray));
  }
  const RadarVolume volume = DecodeRays(rays);
  ASSERT_EQ(volume.sweeps.size(), 2U);
  EXPECT_EQ(volume.sweeps[0].rays.size(), 401U);
}

TEST(Assembly, SaysWhichRaysAreMissing)
{
  RayPlan ray;
  ray.status = 3;
  std::vector<Bytes> rays;
  for (unsigned number = 1; number <= 20; ++number)
  {
    if (number < 6 || (number > 9 && number != 15))
    {
      ray.number = number;
      ray.azimuth = number;
      rays.push_back(MakeMessage31(ray));
      ray.status = 1;
    }
  }
  const RadarVolume volume = DecodeRays(rays);
  EXPECT_TRUE(HasDamage(volume, "5 rays missing in sweep 0 (elevation number 1), in 2 gaps, the "
                                "first between azimuth 5.00 and 10.00 degrees"));
  EXPECT_TRUE(HasDamage(volume, "no end of volume"));
  EXPECT_FALSE(volume.complete);
}

TEST(Assembly, ACutThatIsScannedAgainIsNoDamage)
{
  RayPlan ray;
  ray.status = 3;
  const Bytes brokenOff = MakeSweepBytes(31, ray, 30, 1);
  ray.status = 0;
  ray.milliseconds += 3'000;
  const RadarVolume volume = DecodeRays({brokenOff, MakeSweepBytes(31, ray, 40, 4)});
  ASSERT_EQ(volume.sweeps.size(), 2U);
  EXPECT_TRUE(volume.damage.empty());
  EXPECT_TRUE(HasNote(volume, "sweep 0 (elevation number 1) was interrupted and restarted"));
  // Another cut in its place means that rays were lost.
  ray.cut = 2;
  EXPECT_TRUE(HasDamage(
    DecodeRays({brokenOff, MakeSweepBytes(31, ray, 40, 4)}), "rays missing at the end of sweep 0"));
}

TEST(Assembly, RaysOutsideTheirAnglesAreDamage)
{
  RayPlan ray;
  ray.status = 3;
  RayPlan wild = ray;
  wild.elevation = 95.0;
  wild.status = 1;
  RayPlan end = ray;
  end.status = 4;
  end.number = 2;
  const RadarVolume volume =
    DecodeRays({MakeMessage31(ray), MakeMessage31(wild), MakeMessage31(wild), MakeMessage31(end)});
  EXPECT_EQ(volume.RayCount(), 2U);
  ASSERT_EQ(volume.damage.size(), 1U);
  EXPECT_EQ(volume.damage[0].offset, 24 + MakeMessage31(ray).size());
  EXPECT_NE(volume.damage[0].what.find("elevation is not within"), std::string::npos);
  EXPECT_NE(volume.damage[0].what.find("(and 1 more"), std::string::npos);
}

// An encoder of the antenna can give them; the merge leaves them out.
TEST(Assembly, RaysFarBelowTheirCutAreKept)
{
  RayPlan ray;
  ray.status = 3;
  RayPlan low = ray;
  low.elevation = -9.5;
  low.number = 2;
  low.status = 1;
  RayPlan end = ray;
  end.status = 4;
  end.number = 3;
  for (const auto make : {MakeMessage1, MakeMessage31})
  {
    const RadarVolume volume = DecodeRays({make(ray), make(low), make(end)});
    EXPECT_TRUE(volume.damage.empty());
    ASSERT_EQ(volume.RayCount(), 3U);
    EXPECT_WITHIN(volume.sweeps[0].rays[1].elevation, -9.5, 0.045, "elevation of a ray, degrees");
    EXPECT_WITHIN(volume.sweeps[0].MedianElevation(), 0.5, 0.025, "median elevation, degrees");
    ASSERT_FALSE(volume.notes.empty());
    EXPECT_NE(volume.notes.back().find("1 of its 3 rays farther"), std::string::npos);
  }
}

TEST(Assembly, TheListOfDamageStaysReadable)
{
  RayPlan high;
  high.elevation = 95.0;
  RayPlan astray;
  astray.azimuth = 400.0;
  const Bytes pair = Join({MakeMessage31(high), MakeMessage31(astray)});
  const RadarVolume volume = DecodeRays(std::vector<Bytes>(600, pair));
  EXPECT_EQ(volume.damage.size(), 1002U);
  EXPECT_TRUE(HasDamage(volume, "200 more places are damaged, from here on"));
  EXPECT_EQ(volume.damage.back().what, "no ray can be read");
}

TEST(Assembly, GoesOnBehindABadRecord)
{
  const Bytes volume = MakeSmallVolume(1);
  const Bytes good = InRecords(1, 4 * 2432); // seven records
  // Record 3 (rays 9 to 12, less the two messages in front) loses bytes in its middle.
  std::size_t place = 24;
  for (int record = 0; record < 2; ++record)
  {
    place += 4 + (std::size_t(good[place + 2]) << 8 | good[place + 3]);
  }
  Bytes bad = good;
  for (std::size_t byte = place + 40; byte < place + 60; ++byte)
  {
    bad[byte] ^= 0x5A;
  }
  const RadarVolume decoded = Decode(bad);
  EXPECT_EQ(decoded.RayCount(), 20U);
  EXPECT_TRUE(decoded.complete);
  ASSERT_FALSE(decoded.damage.empty());
  EXPECT_EQ(decoded.damage[0].offset, place);
  EXPECT_EQ(decoded.damage[0].what, "compressed record: the bzip2 stream is corrupt");
  EXPECT_TRUE(HasDamage(decoded, "4 rays missing in sweep 0"));
}

TEST(Assembly, TheCapsHold)
{
  const Bytes large = Join({MakeVolumeHeader(), MakeLdmRecord(Bytes(200'000)),
    MakeLdmRecord(MakeSweepBytes(1, {}, 12, 4), true)});
  Level2Options options;
  options.maximumRecordBytes = 100'000;
  const RadarVolume cut = Decode(large, "file", options);
  EXPECT_TRUE(HasDamage(cut, "more than 100000 bytes when decompressed"));
  EXPECT_EQ(cut.RayCount(), 12U);
  options.maximumFileBytes = 90'000;
  EXPECT_TRUE(
    HasDamage(Decode(large, "file", options), "decoding takes more than 90000 bytes of memory"));
}

TEST(Assembly, TakesTheNameFromWhereItIs)
{
  const auto named = [](const std::string& header, const std::string& inRays,
                       const std::string& file, const std::string& option)
  {
    RayPlan ray;
    ray.site = inRays;
    Level2Options options;
    options.siteName = option;
    return Decode(Join({MakeVolumeHeader("AR2V0006", header), MakeMessage31(ray)}), file, options)
      .site.name;
  };
  EXPECT_EQ(named("KLSX", "KTLX", "KEAX20060312", "KILX"), "KILX");
  // The rays state where KTLX stands.
  EXPECT_EQ(named("KLSX", "KTLX", "KEAX20060312", ""), "KTLX");
  EXPECT_EQ(named("KLSX", "KDDC", "KEAX20060312", ""), "KLSX");
  EXPECT_EQ(named("    ", "KTLX", "KEAX20060312", ""), "KTLX");
  EXPECT_EQ(named("", "", "/data/KEAX20060312_1800.gz", ""), "KEAX");
  EXPECT_EQ(named("", "", "Level2_KFTG_20150430", ""), "KFTG");
  EXPECT_EQ(named("", "", "volume", ""), "");
}

TEST(Assembly, TheAntennasHeightCountsTheFeedhornButForTdwr)
{
  RayPlan ray;
  const auto altitude = [&ray] { return DecodeRays({MakeMessage31(ray)}).site.position->altitude; };
  EXPECT_EQ(altitude(), 390.0);
  ray.site = "TDAL";
  const Bytes terminal = Join({MakeVolumeHeader("AR2V0008", "TDAL"), MakeMessage31(ray)});
  EXPECT_EQ(Decode(terminal).site.position->altitude, 370.0);
  // A terminal radar that the table does not know shows itself by its pattern.
  ray.pattern = 80;
  EXPECT_EQ(Decode(Join({MakeVolumeHeader("AR2V0008", "TXXX"), MakeMessage31(ray)}))
              .site.position->altitude,
    370.0);
}

TEST(Assembly, HeightsInFeetAreFoundByTheSiteTable)
{
  // KTYX as its file of 2010-09-11 has it: the table has 563 m for the ground and 597.4 m for the
  // antenna.
  RayPlan ray;
  ray.siteHeight = 171;
  ray.feedhornHeight = 9;
  const auto decode = [&ray](const char* site)
  {
    ray.site = site;
    return Decode(Join({MakeVolumeHeader("AR2V0004", site), MakeMessage31(ray)}));
  };
  const double listed = FindSite("KTYX")->position.altitude;
  const RadarVolume inFeet = decode("KTYX");
  EXPECT_EQ(inFeet.site.position->altitude, listed);
  EXPECT_EQ(inFeet.storedAltitude, 180.0);
  EXPECT_TRUE(HasNote(
    inFeet, "height in the file, 180 m, is not the site table's, 597 m, but is it as feet"));
  // The file has the last word otherwise, and small differences are no news.
  ray.siteHeight = int(listed) + 150;
  const RadarVolume moved = decode("KTYX");
  EXPECT_EQ(moved.site.position->altitude, ray.siteHeight + 9.0);
  EXPECT_TRUE(HasNote(moved, "the site table's, 597 m: the file's is used"));
  ray.siteHeight = int(listed) + 80;
  EXPECT_FALSE(HasNote(decode("KTYX"), "height"));
  ray.siteHeight = 5000;
  EXPECT_FALSE(HasNote(decode("KXXX"), "height"));
}

TEST(Assembly, PositionsInThousandthsAreNoted)
{
  RayPlan ray;
  ray.latitude = 32926.0F;
  ray.longitude = -96968.0F;
  const RadarVolume volume = DecodeRays({MakeMessage31(ray)});
  ASSERT_TRUE(volume.site.position);
  EXPECT_DOUBLE_EQ(volume.site.position->latitude, 32.926);
  EXPECT_DOUBLE_EQ(volume.site.position->longitude, -96.968);
  EXPECT_TRUE(HasNote(volume, "thousandths"));
}

TEST(Assembly, PositionsComeFromTheTableOrTheOption)
{
  const Bytes bytes = MakeSmallVolume(1);
  const RadarVolume fromTable = Decode(bytes);
  ASSERT_TRUE(fromTable.site.position);
  EXPECT_EQ(fromTable.site.position->latitude, FindSite("KTLX")->position.latitude);
  EXPECT_TRUE(HasNote(fromTable, "site table"));
  Level2Options options;
  options.position = Position{1.0, 2.0, 3.0};
  EXPECT_EQ(Decode(bytes, "file", options).site.position->altitude, 3.0);
  options = {};
  options.siteName = "ZZZZ";
  EXPECT_FALSE(Decode(bytes, "file", options).site.position);
}

TEST(Assembly, NotesAHeaderOfAnotherTimeAndMidnight)
{
  RayPlan ray;
  ray.milliseconds = 86'399'900;
  RayPlan next = ray;
  next.day += 1;
  next.milliseconds = 100;
  next.number = 2;
  const RadarVolume volume = DecodeRays({MakeMessage31(ray), MakeMessage31(next)});
  EXPECT_TRUE(HasNote(volume, "midnight"));
  EXPECT_TRUE(HasNote(volume, "the header's time"));
  EXPECT_EQ(*volume.End() - *volume.Start(), Duration(200));
}

TEST(Assembly, SeveralCyclesUnderOneHeaderComeApart)
{
  RayPlan again;
  again.status = 3;
  again.milliseconds += 5'000;
  RayPlan second = again;
  second.cut = 2;
  second.status = 0;
  second.milliseconds += 1'000;
  const Bytes twice = Join(
    {MakeSmallVolume(31), MakeSweepBytes(31, again, 12, 2), MakeSweepBytes(31, second, 12, 4)});
  const RadarVolume volume = Decode(twice);
  EXPECT_EQ(volume.sweeps.size(), 4U);
  EXPECT_EQ(SplitCycles(volume).size(), 2U);
  // Also where the ray that starts the second cycle is lost.
  RayPlan ray;
  ray.cut = 2;
  RayPlan restart;
  restart.number = 5;
  restart.milliseconds += 5'000;
  EXPECT_EQ(SplitCycles(DecodeRays({MakeMessage31(ray), MakeMessage31(restart)})).size(), 2U);
}

TEST(ChunkFolders, AreReadInTheOrderOfTheirNumbers)
{
  const TemporaryFolder folder;
  RayPlan ray;
  ray.status = 3;
  Write(folder.Path() / "20210729-123848-003-E", MakeLdmRecord(MakeSweepBytes(
                                                   31,
                                                   [&]
                                                   {
                                                     RayPlan last = ray;
                                                     last.cut = 2;
                                                     last.status = 0;
                                                     return last;
                                                   }(),
                                                   5, 4)));
  Write(folder.Path() / "20210729-123848-001-S",
    Join({MakeVolumeHeader(), MakeLdmRecord(MakeMessage5(21, {0.5, 1.5}))}));
  Write(folder.Path() / "20210729-123848-002-I", MakeLdmRecord(MakeSweepBytes(31, ray, 5, 2)));
  Write(folder.Path() / "notes.txt", {'x'});
  const RadarVolume volume = ReadLevel2(folder.Path());
  ASSERT_EQ(volume.sweeps.size(), 2U);
  EXPECT_EQ(volume.sweeps[1].elevationNumber, 2);
  EXPECT_TRUE(volume.damage.empty());
  EXPECT_TRUE(volume.complete);

  std::filesystem::remove(folder.Path() / "20210729-123848-002-I");
  EXPECT_TRUE(
    HasDamage(ReadLevel2(folder.Path()), "20210729-123848-003-E: 1 chunk missing before this one"));
  Write(folder.Path() / "20200101-000000-001-S", MakeVolumeHeader());
  EXPECT_TRUE(HasDamage(
    ReadLevel2(folder.Path()), "20200101-000000-001-S: a chunk of another volume, left out"));
}

TEST(ChunkFolders, WithoutAChunkAreAnError)
{
  const TemporaryFolder folder;
  EXPECT_THROW(ReadLevel2(folder.Path()), Error);
  Write(folder.Path() / "alone", MakeSmallVolume(31));
  EXPECT_EQ(ReadLevel2(folder.Path()).RayCount(), 24U);
}

TEST(LooksLikeLevel2, KnowsTheFirstBytes)
{
  const TemporaryFolder folder;
  const auto looks = [&folder](const Bytes& bytes)
  {
    Write(folder.Path() / "file", bytes);
    return LooksLikeLevel2(folder.Path() / "file");
  };
  const Bytes bare = MakeSmallVolume(1);
  EXPECT_TRUE(looks(bare));
  EXPECT_TRUE(looks(Join({MakeVolumeHeader("ARCHIVE2", ""), bare})));
  EXPECT_TRUE(looks(Gzip(bare)));
  EXPECT_TRUE(looks(Bzip2(bare)));
  EXPECT_TRUE(looks(Compress(bare)));
  EXPECT_TRUE(looks(MakeLdmRecord(bare)));
  EXPECT_FALSE(looks({}));
  EXPECT_FALSE(looks({'A', 'R', '2'}));
  EXPECT_FALSE(looks(Bytes(100, 'x')));
  EXPECT_FALSE(LooksLikeLevel2(folder.Path() / "absent"));
  EXPECT_FALSE(LooksLikeLevel2(folder.Path()));
}

// One bit of the latitude of the first ray moved the radar by 16 degrees.
TEST(Assembly, TheRadarStandsWhereMostRaysSay)
{
  std::vector<Bytes> rays;
  for (unsigned number = 1; number <= 12; ++number)
  {
    RayPlan ray;
    ray.number = number;
    ray.azimuth = number;
    ray.milliseconds += number * 50;
    ray.status = number == 1 ? 3 : number == 12 ? 4 : 1;
    ray.latitude = number == 1 ? 51.33F : ray.latitude;
    rays.push_back(MakeMessage31(ray));
  }
  const RadarVolume volume = DecodeRays(rays);
  EXPECT_EQ(volume.RayCount(), 12U);
  EXPECT_NEAR(volume.site.position->latitude, 35.33, 1e-5);
  EXPECT_TRUE(HasDamage(volume, "1 of 12 rays state another position"));
  EXPECT_FALSE(HasNote(volume, "the site table at"));
}

TEST(Assembly, APlaceFarFromTheSiteTableIsNoted)
{
  RayPlan ray;
  ray.latitude = 51.33F;
  const RadarVolume volume = DecodeRays({MakeSweepBytes(31, ray, 12, 4)});
  EXPECT_NEAR(volume.site.position->latitude, 51.33, 1e-5);
  EXPECT_TRUE(
    HasNote(volume, "the file has KTLX at 51.330, -97.280 degrees, the site table at 35"));
}

TEST(Assembly, AFolderOfChunksWithWhatCannotBeRead)
{
  const TemporaryFolder folder;
  Write(folder.Path() / "20050821-024319-001-S", MakeVolumeHeader());
  Write(
    folder.Path() / "20050821-024319-002-I", MakeLdmRecord(MakeSweepBytes(31, RayPlan(), 12, 4)));
  // Nobody writes to this pipe; to open it would wait for ever.
  ASSERT_EQ(mkfifo((folder.Path() / "20050821-024319-003-E").c_str(), 0600), 0);
  EXPECT_EQ(ReadLevel2(folder.Path()).RayCount(), 12U);
}

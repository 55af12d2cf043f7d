// SPDX-License-Identifier: BSD-3-Clause
// What archives hand out: tars of volumes, and files of metadata alone beside the volumes. All
// SYNTHETIC.
#include "nexrad/Series/ScanInputs.h"

#include "Feed/ChunkMaker.h"
#include "Feed/TarMaker.h"
#include "HandMadeVolume.h"
#include "TestData.h"

#include <gtest/gtest.h>

#include <chrono>
#include <filesystem>
#include <string>
#include <vector>

using namespace nexrad;
using namespace nexrad::testing;
namespace fs = std::filesystem;

namespace
{

const Site site = {"KEAX", Position{38.81, -94.264, 333.0}};

Bytes VolumeAt(int minutes)
{
  const TemporaryFolder folder;
  const Time start = Time(std::chrono::hours(24 * 15000) + std::chrono::minutes(minutes));
  const std::string content =
    FileContent(WriteLevel2(folder.Path() / "volume", {ConstantVolume(site, start, 20.0)}));
  return {content.begin(), content.end()};
}

Bytes MetadataAlone()
{
  return Join({MakeVolumeHeader(), MakeLdmRecord(MakeFrame(29, Bytes(200)), true)});
}

std::vector<std::string> LinesOf(const SeriesScan& scan)
{
  std::vector<std::string> lines;
  for (const InputProblem& problem : scan.problems)
  {
    lines.push_back(problem.Line());
  }
  return lines;
}

} // namespace

TEST(ArchivedInputs, ATarIsAsItsFolder)
{
  const TemporaryFolder folder;
  const Bytes first = VolumeAt(0);
  const Bytes second = VolumeAt(10);
  const fs::path tar =
    WriteBytes(folder.Path() / "day.tar", MakeTar({{"KEAX1", first}, {"KEAX2.gz", Gzip(second)},
                                            {"inner.tar", MakeTar({{"KEAX3", VolumeAt(20)}})}}));
  fs::create_directory(folder.Path() / "day");
  for (const fs::path& input : {tar, folder.Path()}) // itself, and in a folder
  {
    const auto scan = ScanInputs({input});
    EXPECT_TRUE(scan->problems.empty()) << LinesOf(*scan).front();
    ASSERT_EQ(scan->sites.size(), 1U);
    ASSERT_EQ(scan->sites[0].volumes.size(), 3U);
    EXPECT_EQ(scan->sites[0].volumes[0].file, tar / "KEAX1");
    EXPECT_EQ(scan->sites[0].volumes[1].file, tar / "KEAX2.gz");
    EXPECT_EQ(scan->sites[0].volumes[2].file, tar / "inner.tar" / "KEAX3");
  }
  EXPECT_EQ(ReadLevel2(tar / "KEAX2.gz").RayCount(), 360U);
  EXPECT_EQ(ScanInputs({tar / "KEAX2.gz"})->sites[0].volumes.size(), 1U);
}

TEST(ArchivedInputs, MembersAreNamedInProblems)
{
  const TemporaryFolder folder;
  Bytes volume = VolumeAt(0);
  volume.resize(volume.size() / 2);
  const fs::path tar =
    WriteBytes(folder.Path() / "day.tar", MakeTar({{"half", volume}, {"readme.txt", {'h', 'i'}},
                                            {"holes", {1}, 'S'}, {"more.zip", {'P', 'K', 3, 4}}}));
  std::vector<std::string> lines = LinesOf(*ScanInputs({tar}));
  ASSERT_GE(lines.size(), 4U);
  EXPECT_EQ(lines[0], (tar / "holes").string() + ": a sparse file, which is not read: left out");
  EXPECT_EQ(lines[1], (tar / "more.zip").string() + ": a zip archive; unpack it first: left out");
  EXPECT_EQ(lines[2], (tar / "readme.txt").string() + ": not a Level II file: left out");
  EXPECT_EQ(lines[3].rfind((tar / "half").string() + ": offset ", 0), 0U) << lines[3];
}

TEST(ArchivedInputs, ATarThatIsCutGivesItsWholeMembers)
{
  const TemporaryFolder folder;
  const Bytes first = MakeTarMember({"KEAX1", VolumeAt(0)});
  const Bytes tar = Join({first, MakeTarMember({"KEAX2", VolumeAt(10)})});
  const std::size_t places[] = {
    first.size(), first.size() + 100, first.size() + 512, first.size() + 600, tar.size()};
  for (const std::size_t size : places)
  {
    const fs::path path = WriteBytes(folder.Path() / "cut.tar",
      Bytes(tar.begin(), tar.begin() + static_cast<std::ptrdiff_t>(size)));
    const auto scan = ScanInputs({path});
    ASSERT_EQ(scan->sites.size(), 1U) << size;
    EXPECT_EQ(scan->sites[0].volumes[0].rays, 360U) << size;
    EXPECT_FALSE(scan->problems.empty()) << size;
  }
}

TEST(ArchivedInputs, ChunksInATarAreOneVolume)
{
  const TemporaryFolder folder;
  const Bytes volume = MakeSmallVolume(31);
  const auto middle = volume.begin() + 24;
  const fs::path tar = WriteBytes(folder.Path() / "feed.tar",
    MakeTar({{"KTLX/7/20050821-024319-001-S", Bytes(volume.begin(), middle)},
      {"KTLX/7/20050821-024319-002-E", Bytes(middle, volume.end())}}));
  const auto scan = ScanInputs({tar});
  ASSERT_EQ(scan->sites.size(), 1U);
  ASSERT_EQ(scan->sites[0].volumes.size(), 1U);
  EXPECT_EQ(scan->sites[0].volumes[0].rays, 24U);
  EXPECT_EQ(scan->sites[0].volumes[0].file, tar / "KTLX" / "7");
}

TEST(ArchivedInputs, FilesOfMetadataAloneArePassedOver)
{
  const TemporaryFolder folder;
  WriteBytes(folder.Path() / "KEAX1", VolumeAt(0));
  const fs::path metadata = WriteBytes(folder.Path() / "KEAX1_MDM", MetadataAlone());
  const auto scan = ScanInputs({folder.Path()});
  EXPECT_TRUE(scan->problems.empty()) << LinesOf(*scan).front();
  EXPECT_EQ(scan->sites.at(0).volumes.size(), 1U);
  EXPECT_EQ(scan->notes,
    std::vector<std::string>{metadata.string() + ": metadata alone, no ray: passed over"});
  const RadarVolume volume = ReadLevel2(metadata);
  EXPECT_TRUE(HoldsMetadataAlone(volume));
  EXPECT_EQ(volume.notes.at(0), "metadata alone, no ray: message 29");
}

// A header without anything, and metadata that are cut off, are damage as before.
TEST(ArchivedInputs, FilesThatLostTheirRaysAreDamage)
{
  const Bytes metadata =
    Join({MakeVolumeHeader(), MakeMessage2(21, 1900), MakeMessage5(21, {0.5})});
  EXPECT_TRUE(HoldsMetadataAlone(DecodeLevel2(metadata, "whole")));
  EXPECT_FALSE(HoldsMetadataAlone(DecodeLevel2(MakeVolumeHeader(), "header")));
  EXPECT_FALSE(HoldsMetadataAlone(
    DecodeLevel2(Bytes(metadata.begin(), metadata.begin() + 24 + 2432 + 40), "cut")));
  EXPECT_FALSE(HoldsMetadataAlone(DecodeLevel2({}, "empty")));
  Bytes broken = MetadataAlone();
  broken[60] ^= 0xFF;
  EXPECT_FALSE(HoldsMetadataAlone(DecodeLevel2(broken, "broken")));
}

TEST(ArchivedInputs, FilesOfOtherFormatsAreNamed)
{
  const TemporaryFolder folder;
  const fs::path zip = WriteBytes(folder.Path() / "day.zip", {'P', 'K', 3, 4, 20, 0});
  const std::string line = zip.string() + ": a zip archive; unpack it first";
  EXPECT_EQ(LinesOf(*ScanInputs({zip})), std::vector<std::string>{line});
  EXPECT_EQ(LinesOf(*ScanInputs({folder.Path()})), std::vector<std::string>{line + ": left out"});
}
